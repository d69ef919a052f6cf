#include "results/quality.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "results/constants.h"

namespace knitmech::results {
namespace {

using model::HistoryRow;
using model::RunOutcome;
using model::RunStatus;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double kDiameter = 0.12;

/// A test to 20 % strain in 200 rows whose work grows with the cube of the strain up to 1 mJ: 80 % internal energy, 16
/// % friction loss, 4 % contact energy, no kinetic energy, equal grip forces.
std::vector<HistoryRow> perfect_history() {
  std::vector<HistoryRow> history;
  for (int i = 0; i <= 200; ++i) {
    HistoryRow row;
    row.strain = 0.001 * i;
    row.external_work = std::pow(row.strain / 0.2, 3);
    row.internal_energy = 0.80 * row.external_work;
    row.friction_loss = 0.16 * row.external_work;
    row.contact_energy = 0.04 * row.external_work;
    row.force_top = row.force_bottom = std::pow(row.strain / 0.2, 2);
    history.push_back(row);
  }
  return history;
}

TEST(Quality, AnIdealTestIsQuasiStaticAndSaysSo) {
  RunOutcome outcome;
  outcome.largest_penetration = 0.006;
  const Quality quality = assess_quality(perfect_history(), outcome, kDiameter);
  EXPECT_TRUE(quality.quasi_static);
  EXPECT_NEAR(*quality.kinetic_ratio, 0, 1e-14);
  EXPECT_NEAR(*quality.energy_balance, 0, 1e-14);
  EXPECT_NEAR(*quality.grip_difference, 0, 1e-14);
  EXPECT_DOUBLE_EQ(quality.penetration, 0.006);
  EXPECT_DOUBLE_EQ(quality.penetration_ratio, 0.05);
  EXPECT_THAT(quality.verdict, HasSubstr("Quasi-static"));
}

TEST(Quality, TheElasticSlipIsTheLargestOfTheWholeHistoryOverTheDiameter) {
  // Given sticks that stretch by 0.0006 mm in the toe region and by less afterwards, on a yarn of 0.12 mm.
  std::vector<HistoryRow> history = perfect_history();
  history[10].largest_elastic_slip = 0.0006;
  history[150].largest_elastic_slip = 0.0003;
  const Quality quality = assess_quality(history, {}, kDiameter);
  EXPECT_EQ(quality.elastic_slip, 0.0006);
  EXPECT_DOUBLE_EQ(quality.elastic_slip_ratio, 0.005);
  // Without diameter there is no ratio.
  EXPECT_EQ(assess_quality(history, {}, 0.0).elastic_slip, 0.0006);
  EXPECT_EQ(assess_quality(history, {}, 0.0).elastic_slip_ratio, 0.0);
}

TEST(Quality, TheElasticSlipIsKnownOfARunThatNeverLeftTheToeRegion) {
  // Given a history without work, of which nothing else can be judged.
  std::vector<HistoryRow> history(3);
  history[1].largest_elastic_slip = 0.0006;
  const Quality quality = assess_quality(history, {}, kDiameter);
  ASSERT_FALSE(quality.toe_strain.has_value());
  EXPECT_DOUBLE_EQ(quality.elastic_slip_ratio, 0.005);
}

TEST(Quality, TheToeEndsWhereTheWorkReachesItsShare) {
  // Given work (strain / 0.2)^3, which is 10 % at strain 0.2 * 0.1^(1/3) = 0.09283: the first row after it is at 0.093.
  const Quality quality = assess_quality(perfect_history(), {}, kDiameter);
  EXPECT_NEAR(*quality.toe_strain, 0.093, 1e-12);
}

TEST(Quality, TheToeEndsAtTheLastTimeTheWorkIsSmall) {
  // Given a start-up shock whose work is given back at once.
  std::vector<HistoryRow> history = perfect_history();
  history[10].external_work = 0.5;
  history[10].kinetic_energy = 0.5;
  // Then the shock is part of the toe.
  const Quality quality = assess_quality(history, {}, kDiameter);
  EXPECT_NEAR(*quality.toe_strain, 0.093, 1e-12);
  EXPECT_TRUE(quality.quasi_static);
}

TEST(Quality, TooMuchKineticEnergyFailsWithWhereAndAdvice) {
  // Given 8 % kinetic over internal energy from 13 to 16 % strain, balanced by more work.
  std::vector<HistoryRow> history = perfect_history();
  for (std::size_t i = 130; i <= 160; ++i) {
    history[i].kinetic_energy = 0.08 * history[i].internal_energy;
    history[i].external_work += history[i].kinetic_energy;
  }
  const Quality quality = assess_quality(history, {}, kDiameter);
  EXPECT_FALSE(quality.quasi_static);
  EXPECT_NEAR(*quality.kinetic_ratio, 0.08, 1e-12);
  EXPECT_GE(*quality.kinetic_ratio_strain, 0.13);
  EXPECT_LE(*quality.kinetic_ratio_strain, 0.16);
  EXPECT_THAT(quality.verdict, AllOf(HasSubstr("kinetic energy reaches 8 %"), HasSubstr("limit 5 %"),
                                     HasSubstr("more slowly"), Not(HasSubstr("balance"))));
}

TEST(Quality, AHugeRatioIsToldWithoutDigits) {
  // Given a fabric that flies without strain: internal energy a ten-millionth of the kinetic one.
  std::vector<HistoryRow> history = perfect_history();
  for (HistoryRow& row : history) {
    row.kinetic_energy = row.internal_energy;
    row.internal_energy *= 1e-7;
  }
  const Quality quality = assess_quality(history, {}, kDiameter);
  EXPECT_FALSE(quality.quasi_static);
  EXPECT_THAT(quality.verdict, HasSubstr("kinetic energy reaches a multiple of the internal energy"));
}

TEST(Quality, AShortSnapIsJudgedByItsMeanOverOnePercentStrain) {
  // Given one row of ten in a window with 30 % kinetic over internal energy.
  std::vector<HistoryRow> history = perfect_history();
  history[150].kinetic_energy = 0.3 * history[150].internal_energy;
  history[150].external_work += history[150].kinetic_energy;
  const Quality quality = assess_quality(history, {}, kDiameter);
  EXPECT_NEAR(*quality.kinetic_ratio, 0.03, 0.01);
  EXPECT_TRUE(quality.quasi_static);
}

TEST(Quality, MissingEnergyFailsAtTheEndAndOnTheWay) {
  // Given 2 % of the work missing at one row, 0.5 % at the last.
  std::vector<HistoryRow> history = perfect_history();
  history[120].friction_loss -= 0.02 * history[120].external_work;
  history.back().friction_loss -= 0.005 * history.back().external_work;
  const Quality quality = assess_quality(history, {}, kDiameter);
  EXPECT_FALSE(quality.quasi_static);
  EXPECT_NEAR(*quality.energy_balance, 0.02, 1e-12);
  EXPECT_NEAR(*quality.energy_balance_strain, 0.12, 1e-12);
  EXPECT_NEAR(*quality.energy_balance_end, 0.005, 1e-12);
  EXPECT_THAT(quality.verdict, HasSubstr("energy balance is off by 2 %"));
}

TEST(Quality, GripForcesAreComparedAfterAveragingOverOnePercentStrain) {
  // Given grip forces that swing by +-30 % from row to row, but not on average.
  std::vector<HistoryRow> history = perfect_history();
  for (std::size_t i = 0; i < history.size(); ++i) {
    history[i].force_top *= i % 2 == 0 ? 1.3 : 0.7;
  }
  EXPECT_LT(*assess_quality(history, {}, kDiameter).grip_difference, kGripDifferenceLimit);
  // Given a bottom force that is 10 % low throughout: |1 - 0.9| / 0.95.
  history = perfect_history();
  for (HistoryRow& row : history) {
    row.force_bottom *= 0.9;
  }
  const Quality quality = assess_quality(history, {}, kDiameter);
  EXPECT_NEAR(*quality.grip_difference, 0.1 / 0.95, 1e-12);
  EXPECT_FALSE(quality.quasi_static);
  EXPECT_THAT(quality.verdict, HasSubstr("grip forces differ by 11 %"));
}

TEST(Quality, ALostCrossingIsNeverQuasiStatic) {
  RunOutcome outcome;
  outcome.lost_crossings = 2;
  const Quality quality = assess_quality(perfect_history(), outcome, kDiameter);
  EXPECT_FALSE(quality.quasi_static);
  EXPECT_THAT(quality.verdict, HasSubstr("2 crossings were lost"));
}

TEST(Quality, AFailedRunIsNotQuasiStaticAndAnInterruptedOneIsJudgedUpToThere) {
  RunOutcome outcome;
  outcome.strain = 0.2;
  outcome.status = RunStatus::failed;
  const Quality failed = assess_quality(perfect_history(), outcome, kDiameter);
  EXPECT_FALSE(failed.quasi_static);
  EXPECT_THAT(failed.verdict, HasSubstr("failed at 20.0 % strain"));
  outcome.status = RunStatus::interrupted;
  const Quality interrupted = assess_quality(perfect_history(), outcome, kDiameter);
  EXPECT_TRUE(interrupted.quasi_static);
  EXPECT_THAT(interrupted.verdict, AllOf(HasSubstr("interrupted at 20.0 % strain"), HasSubstr("Quasi-static")));
}

TEST(Quality, EmptyAndForcelessHistoriesSayNothing) {
  for (const std::vector<HistoryRow>& history : {std::vector<HistoryRow>{}, std::vector<HistoryRow>(50)}) {
    const Quality quality = assess_quality(history, {}, 0);
    EXPECT_FALSE(quality.quasi_static);
    EXPECT_FALSE(quality.toe_strain.has_value());
    EXPECT_FALSE(quality.kinetic_ratio.has_value());
    EXPECT_FALSE(quality.energy_balance.has_value());
    EXPECT_FALSE(quality.grip_difference.has_value());
    EXPECT_EQ(quality.penetration_ratio, 0);
    EXPECT_THAT(quality.verdict, HasSubstr("never left the toe region"));
  }
}

TEST(Quality, ASingleRowWithWorkIsJudged) {
  HistoryRow row;
  row.strain = 0.01;
  row.external_work = row.internal_energy = 1;
  row.force_top = row.force_bottom = 1;
  EXPECT_TRUE(assess_quality({row}, {}, kDiameter).quasi_static);
}

TEST(Quality, AnExplosionIsFoundWantingWithoutNotANumber) {
  // Given a run whose last row is not a number any more.
  std::vector<HistoryRow> history = perfect_history();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double HistoryRow::*member : {&HistoryRow::external_work, &HistoryRow::internal_energy,
                                     &HistoryRow::kinetic_energy, &HistoryRow::force_top}) {
    history.back().*member = nan;
  }
  const Quality quality = assess_quality(history, {}, kDiameter);
  EXPECT_FALSE(quality.quasi_static);
  for (const auto& value : {quality.kinetic_ratio, quality.energy_balance, quality.grip_difference}) {
    ASSERT_TRUE(value.has_value());
    EXPECT_TRUE(std::isinf(*value));
  }
  EXPECT_THAT(quality.verdict, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace knitmech::results
