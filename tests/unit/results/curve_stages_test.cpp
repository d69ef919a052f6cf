#include "results/curve_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "results/constants.h"
#include "results/curve_measures.h"

namespace knitmech::results {
namespace {

constexpr double kWidth = 20;         // [mm]
constexpr double kBending = 1;        // [mJ], so that the toe ends at kToeEnergy mJ
constexpr double kToeEnd = 0.1234;    // [-]
constexpr double kStretchFrom = 0.3;  // [-]
constexpr double kBendingSlope = 2;   // [N]
constexpr double kStretchSlope = 30;  // [N]

/// A history whose stages are known: no energy but a trace up to the toe's end; then bending energy grows by 1 mJ per
/// unit of strain; from kStretchFrom on stretch energy grows by 5 mJ per unit. The force has a slope in each stage.
std::vector<model::HistoryRow> known_history(double end, double spacing = 0.0005) {
  std::vector<model::HistoryRow> rows;
  const int n = static_cast<int>(std::lround(end / spacing));
  for (int i = 0; i <= n; ++i) {
    model::HistoryRow row;
    row.strain = end * i / n;
    const double after_toe = std::max(0.0, row.strain - kToeEnd);
    const double stretched = std::max(0.0, row.strain - kStretchFrom);
    const double bending = kToeEnergy * std::min(1.0, row.strain / kToeEnd) + after_toe;
    row.stretch_energy = 5 * stretched;
    row.internal_energy = bending + row.stretch_energy;
    const double force = kBendingSlope * std::min(after_toe, kStretchFrom - kToeEnd) + kStretchSlope * stretched;
    row.force_top = 1.01 * force;
    row.force_bottom = 0.99 * force;
    row.width = kWidth * (1 - 0.4 * row.strain);
    rows.push_back(row);
  }
  return rows;
}

TEST(CurveStages, GivenAHistoryWithKnownKnots_ThenTheStagesAndTheirSlopesAreFound) {
  const CurveStages found = curve_stages(known_history(0.4), kBending);
  ASSERT_EQ(found.stages.size(), 3U);
  EXPECT_EQ(found.stages[0].name, "toe");
  EXPECT_EQ(found.stages[1].name, "bending");
  EXPECT_EQ(found.stages[2].name, "stretching");
  EXPECT_EQ(found.stages[0].from, 0);
  EXPECT_NEAR(found.stages[0].to, kToeEnd, 5e-4);  // the distance of two rows
  EXPECT_EQ(found.stages[1].from, found.stages[0].to);
  EXPECT_EQ(*found.bending_strain, found.stages[0].to);
  // In a window of kWindow that has the share x of stretching, stretch leads where 5 x > 1.
  ASSERT_TRUE(found.stretch_strain);
  EXPECT_NEAR(*found.stretch_strain, kStretchFrom + (0.2 - 0.5) * kWindow, 2e-4);
  EXPECT_EQ(found.stages[1].to, *found.stretch_strain);
  EXPECT_EQ(found.stages[2].from, *found.stretch_strain);
  EXPECT_EQ(found.stages[2].to, 0.4);
  EXPECT_NEAR(*found.stages[0].slope, 0, 1e-12);
  EXPECT_NEAR(*found.stages[1].slope, kBendingSlope, 1e-9);
  EXPECT_NEAR(*found.stages[2].slope, kStretchSlope, 0.02 * kStretchSlope);  // its first rows are before the knot
  EXPECT_NEAR(*found.stages[1].slope_per_width, kBendingSlope / kWidth, 1e-10);
  EXPECT_NEAR(*found.stretch_share, 5.0 / 6.0, 1e-9);
}

TEST(CurveStages, GivenATestThatGoesFurther_ThenTheLimitsStayWhereTheyAre) {
  const CurveStages shorter = curve_stages(known_history(0.35), kBending);
  const CurveStages longer = curve_stages(known_history(0.7), kBending);
  EXPECT_NEAR(shorter.stages[0].to, longer.stages[0].to, 1e-9);
  EXPECT_NEAR(*shorter.stretch_strain, *longer.stretch_strain, 1e-9);
  EXPECT_NEAR(*shorter.stages[1].slope, *longer.stages[1].slope, 1e-9);
}

TEST(CurveStages, GivenATestThatEndsEarly_ThenItHasNoLaterStageAndSaysHowNearItIs) {
  const CurveStages in_toe = curve_stages(known_history(0.1), kBending);
  ASSERT_EQ(in_toe.stages.size(), 1U);
  EXPECT_EQ(in_toe.stages[0].to, 0.1);
  EXPECT_FALSE(in_toe.bending_strain);
  EXPECT_FALSE(in_toe.stretch_share);

  const CurveStages in_bending = curve_stages(known_history(0.25), kBending);
  ASSERT_EQ(in_bending.stages.size(), 2U);
  EXPECT_EQ(in_bending.stages[1].to, 0.25);
  EXPECT_FALSE(in_bending.stretch_strain);
  EXPECT_NEAR(*in_bending.stretch_share, 0, 1e-12);

  // Stretch leads at the end, but for less than a window.
  const CurveStages at_the_knot = curve_stages(known_history(kStretchFrom + 0.5 * kWindow), kBending);
  EXPECT_EQ(at_the_knot.stages.size(), 2U);
  EXPECT_FALSE(at_the_knot.stretch_strain);
  EXPECT_GT(*at_the_knot.stretch_share, 0.5);
}

TEST(CurveStages, GivenASnapThatSetsBendingFreeOnTheWay_ThenStretchingHasNotBegunThere) {
  std::vector<model::HistoryRow> rows = known_history(0.4);
  for (model::HistoryRow& row : rows) {
    if (row.strain > 0.2) row.internal_energy -= 0.02;
  }
  EXPECT_NEAR(*curve_stages(rows, kBending).stretch_strain, *curve_stages(known_history(0.4), kBending).stretch_strain,
              1e-9);
}

TEST(CurveStages, GivenAYarnThatBreaks_ThenTheCurveEndsThere) {
  std::vector<model::HistoryRow> rows = known_history(0.4);
  for (model::HistoryRow& row : rows) row.break_loss = row.strain >= 0.35 ? 0.1 : 0;
  const CurveStages found = curve_stages(rows, kBending);
  ASSERT_EQ(found.stages.size(), 3U);
  EXPECT_NEAR(found.stages[2].to, 0.3495, 1e-9);
}

TEST(CurveStages, GivenFewRowsOrNone_ThenNothingIsInvented) {
  EXPECT_TRUE(curve_stages({}, kBending).stages.empty());
  EXPECT_TRUE(curve_stages({model::HistoryRow{}}, kBending).stages.empty());
  // Rows further apart than the window: the limits are as fine as the rows.
  const CurveStages coarse = curve_stages(known_history(0.4, 0.02), kBending);
  ASSERT_EQ(coarse.stages.size(), 3U);
  EXPECT_NEAR(coarse.stages[0].to, kToeEnd, 0.02);
  EXPECT_NEAR(*coarse.stretch_strain, kStretchFrom, 0.02);
}

TEST(CurveMeasures, GivenAHistoryOfKnownForceAndWidth_ThenStiffnessAndContractionAreTheirFormulas) {
  const std::vector<model::HistoryRow> rows = known_history(0.4);
  const double strain = 0.25003;  // between two rows
  const auto measure = measure_at(rows, strain);
  ASSERT_TRUE(measure);
  const double force = kBendingSlope * (strain - kToeEnd);
  EXPECT_NEAR(measure->force, force, 1e-12);
  EXPECT_NEAR(measure->force_per_width, force / kWidth, 1e-13);
  EXPECT_NEAR(*measure->secant, force / kWidth / strain, 1e-12);
  EXPECT_NEAR(*measure->tangent, kBendingSlope / kWidth, 1e-10);
  EXPECT_NEAR(measure->width, kWidth * (1 - 0.4 * strain), 1e-12);
  EXPECT_NEAR(measure->contraction, 0.4 * strain, 1e-12);
  EXPECT_NEAR(*measure->poissons_ratio, 0.4, 1e-12);
}

TEST(CurveMeasures, GivenTheEndsOfTheCurve_ThenTheyAreMeasuredAndBeyondThemIsNothing) {
  const std::vector<model::HistoryRow> rows = known_history(0.4);
  const auto start = measure_at(rows, 0);
  ASSERT_TRUE(start);
  EXPECT_EQ(start->force, 0);
  EXPECT_FALSE(start->secant);
  EXPECT_FALSE(start->poissons_ratio);
  EXPECT_NEAR(*start->tangent, 0, 1e-12);
  const auto end = measure_at(rows, 0.4);
  ASSERT_TRUE(end);
  EXPECT_NEAR(*end->tangent, kStretchSlope / kWidth, 1e-9);
  EXPECT_FALSE(measure_at(rows, 0.4001));
  EXPECT_FALSE(measure_at(rows, -0.001));
  EXPECT_FALSE(measure_at({}, 0));
  EXPECT_EQ(curve_measures(rows).size(), rows.size());
  EXPECT_EQ(curve_measures(rows)[100].strain, rows[100].strain);
}

TEST(CurveMeasures, GivenRowsFurtherApartThanTheWindow_ThenTheTangentIsThatOfTheNeighbours) {
  const auto measure = measure_at(known_history(0.4, 0.02), 0.2);
  ASSERT_TRUE(measure);
  EXPECT_NEAR(*measure->tangent, kBendingSlope / kWidth, 1e-10);
}

}  // namespace
}  // namespace knitmech::results
