#include "picture/comparison_chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace knitmech::picture {
namespace {

using testing::ElementsAre;

compare::Comparison two_strains(int n_specimens) {
  compare::Comparison comparison;
  comparison.strains = {0, 0.1};
  comparison.simulated = {0, 0.004};
  comparison.mean = {0, 0.003};
  comparison.lowest = {0, 0.002};
  comparison.highest = {0, 0.0125};
  comparison.n_specimens = n_specimens;
  return comparison;
}

TEST(ComparisonChart, GivenTheWidthOfBoth_ThenItShowsTheForcesOnIt) {
  const Chart chart = comparison_chart(two_strains(3), "jersey", 40);
  EXPECT_EQ(chart.y_label, "Force [N]");
  ASSERT_EQ(chart.series.size(), 2U);
  EXPECT_THAT(chart.series[0].x, ElementsAre(0, 10));
  EXPECT_THAT(chart.series[0].y, ElementsAre(0, 0.16));
  EXPECT_EQ(chart.series[1].name, "mean of 3 measured");
  ASSERT_EQ(chart.bands.size(), 1U);
  EXPECT_THAT(chart.bands[0].high, ElementsAre(0, 0.5));
}

TEST(ComparisonChart, GivenNoWidth_ThenItShowsForcesPerWidthAndOneSpecimenHasNoRange) {
  compare::Comparison comparison = two_strains(1);
  comparison.offset = 0.02;
  const Chart chart = comparison_chart(comparison, "jersey", 0);
  EXPECT_EQ(chart.y_label, "Force per width [mN/mm]");
  EXPECT_EQ(chart.x_label, "Strain [%], the measured one less 2");
  EXPECT_THAT(chart.series[0].y, ElementsAre(0, 4));
  EXPECT_TRUE(chart.bands.empty());
}

}  // namespace
}  // namespace knitmech::picture
