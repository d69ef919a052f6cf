#include "report/run_charts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace knitmech::report {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

model::HistoryRow row_at(double strain, double force, double width = 20) {
  model::HistoryRow row;
  row.strain = strain;
  row.force_top = force;
  row.width = width;
  return row;
}

TEST(ForceChart, GivenForcesBelowATenthOfANewtonWhenChartedThenTheyAreInMillinewtonOverPerCent) {
  const picture::Chart chart = force_chart({{"run", {row_at(0, 0), row_at(0.1, 0.02)}}}, false);
  EXPECT_EQ(chart.y_label, "Grip force [mN]");
  EXPECT_THAT(chart.series.front().x, ElementsAre(0, 10));
  EXPECT_THAT(chart.series.front().y, ElementsAre(0, 20));
}

TEST(ForceChart, GivenOneLargeForceAmongRunsWhenChartedThenAllAreInNewton) {
  const picture::Chart chart = force_chart({{"a", {row_at(0.1, 0.02)}}, {"b", {row_at(0.1, 3)}}}, false);
  EXPECT_EQ(chart.y_label, "Grip force [N]");
  EXPECT_THAT(chart.series.front().y, ElementsAre(0.02));
}

TEST(ForceChart, GivenALogarithmicAxisWhenChartedThenForcesFarBelowTheLargestAreGaps) {
  const picture::Chart chart = force_chart({{"run", {row_at(0, 1e-9), row_at(0.1, 2)}}}, true);
  EXPECT_TRUE(chart.log_y);
  EXPECT_TRUE(std::isnan(chart.series.front().y.front()));
  EXPECT_EQ(chart.series.front().y.back(), 2);
}

TEST(ForceChart, GivenALogarithmicAxisWhenChartedThenWavesWithinOnePerCentOfStrainAreAveraged) {
  std::vector<model::HistoryRow> history;
  history.reserve(100);
  for (int i = 0; i < 100; ++i) history.push_back(row_at(0.001 * i, i % 2 == 0 ? 1 : 3));
  const picture::Chart chart = force_chart({{"run", history}}, true);
  for (std::size_t i = 20; i < 100; ++i) EXPECT_NEAR(chart.series.front().y[i], 2, 0.1);
}

TEST(ContractionChart, GivenAFabricThatDrawsInByAFifthWhenChartedThenItIsTwentyPerCent) {
  const picture::Chart chart = contraction_chart({{"run", {row_at(0, 0, 20), row_at(0.1, 1, 16)}}});
  EXPECT_THAT(chart.series.front().y, ElementsAre(DoubleNear(0, 1e-12), DoubleNear(20, 1e-12)));
}

TEST(EnergyChart, GivenEnergiesThatDoNotCountWhenChartedThenTheyAreLeftOut) {
  model::HistoryRow row;
  row.external_work = 1;
  row.internal_energy = 0.6;
  row.friction_loss = 0.4;
  row.kinetic_energy = 0.001;
  const picture::Chart chart = energy_chart({row});
  ASSERT_EQ(chart.series.size(), 3U);
  EXPECT_EQ(chart.series[1].name, "stored in the yarns");
  EXPECT_EQ(chart.series[2].name, "lost to friction");
}

// Two courses of 10 mm, the second drawn in to 6 mm and 4 mm higher.
TEST(WidthProfile, GivenTwoCoursesWhenChartedThenEachHasItsWidthAtItsMeanHeight) {
  model::Model model;
  model.course = {0, 0, 1, 1};
  model::Frame frame;
  frame.history.strain = 0.08;
  frame.points = {{0, 0, 0}, {10, 1, 0}, {2, 4, 0}, {8, 5, 0}};
  const picture::Chart chart = width_profile_chart(model, {frame});
  ASSERT_EQ(chart.series.size(), 1U);
  EXPECT_EQ(chart.series.front().name, "8 %");
  EXPECT_THAT(chart.series.front().x, ElementsAre(0.5, 4.5));
  EXPECT_THAT(chart.series.front().y, ElementsAre(10, 6));
}

}  // namespace
}  // namespace knitmech::report
