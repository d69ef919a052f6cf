#include "picture/force_strain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.h"

namespace knitmech::picture {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<model::HistoryRow> history(double scale, double bottom_share) {
  std::vector<model::HistoryRow> rows;
  for (int i = 0; i <= 22; ++i) {
    model::HistoryRow row;
    row.strain = 0.01 * i;
    row.force_top = scale * i;
    row.force_bottom = bottom_share * row.force_top;
    rows.push_back(row);
  }
  return rows;
}

TEST(ForceStrain, ShowsBothGripsOverTheStrainInPercent) {
  const Chart chart = force_strain_chart(history(0.1, 0.8), "title");
  ASSERT_EQ(chart.series.size(), 2U);
  EXPECT_NEAR(chart.series[0].x.back(), 22, 1e-12);
  EXPECT_NEAR(chart.series[0].y.back(), 2.2, 1e-12);
  EXPECT_NEAR(chart.series[1].y.back(), 0.8 * 2.2, 1e-12);
  EXPECT_EQ(chart.title, "title");
  EXPECT_EQ(chart.y_label, "Grip force [N]");
}

TEST(ForceStrain, ShowsOneLineIfTheGripsCannotBeToldApart) {
  EXPECT_EQ(force_strain_chart(history(0.1, 0.999), "").series.size(), 1U);
}

TEST(ForceStrain, UsesMillinewtonForSmallForces) {
  const Chart chart = force_strain_chart(history(0.001, 1), "");
  EXPECT_EQ(chart.y_label, "Grip force [mN]");
  EXPECT_NEAR(chart.series[0].y.back(), 22, 1e-12);
}

TEST(ForceStrain, AnEmptyHistoryGivesAChartWithoutData) {
  EXPECT_THAT(chart_svg(force_strain_chart({}, "")), HasSubstr("no data"));
}

TEST(ForceStrain, AnUnwritablePathIsAFileError) {
  EXPECT_THAT([] { write_force_strain_chart("/no/such/folder/chart.svg", {}, ""); },
              ThrowsMessage<FileError>(HasSubstr("/no/such/folder/chart.svg")));
}

}  // namespace
}  // namespace knitmech::picture
