// A small fabric, 3 wales x 4 courses on chords, at a pace that the program adapts.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../model/example_case.h"
#include "model/build_model.h"
#include "results/quality.h"
#include "solve/mass_scaling.h"
#include "solve/simulate.h"

namespace knitmech {
namespace {

constexpr double kStrain = 0.16;
constexpr int kRows = 160;

struct Simulation {
  model::RunOutcome outcome;
  std::vector<model::HistoryRow> rows;
  std::vector<model::Frame> frames;

  /// Mean of both grips around a strain [N].
  [[nodiscard]] double force_at(double strain) const {
    double sum = 0;
    int n = 0;
    for (const model::HistoryRow& row : rows) {
      if (std::abs(row.strain - strain) > 0.01) continue;
      sum += 0.5 * (row.force_top + row.force_bottom);
      ++n;
    }
    return sum / n;
  }
};

model::Model small_fabric() {
  model::Case input = model::example_case();
  input.fabric.wales = 3;
  input.fabric.courses = 4;
  input.contact.centreline = model::Centreline::chords;
  input.test.strain = kStrain;
  return model::build_model(input);
}

/// \param slower than the pace that the program starts from
Simulation run(const model::Model& model, bool adapts_pace, double slower = 1, bool selective_mass = false) {
  solve::SimulationSettings settings;
  settings.mass_scaling = solve::automatic_mass_scaling(model) / (slower * slower);
  settings.adapts_pace = adapts_pace;
  settings.selective_mass = selective_mass;
  settings.history_points = kRows;
  settings.frames_at = {0.5 * model.test.strain};
  Simulation run;
  run.outcome = solve::simulate(model, settings,
                                {[&](const model::HistoryRow& row) { run.rows.push_back(row); },
                                 [&](const model::Frame& frame) { run.frames.push_back(frame); },
                                 {}});
  return run;
}

TEST(AdaptedPace, GivenASmallFabric_ThenItIsFasterThanTheConstantSpeedAndTheCurveThatOfASlowTest) {
  const model::Model model = small_fabric();
  const Simulation paced = run(model, true);
  const Simulation constant = run(model, false);
  const Simulation slow = run(model, false, 2);
  EXPECT_LT(paced.outcome.steps, 0.7 * static_cast<double>(constant.outcome.steps));
  for (const double strain : {0.1, 0.12, 0.14}) {
    EXPECT_NEAR(paced.force_at(strain), slow.force_at(strain), 0.04 * slow.force_at(strain)) << strain;
  }
  EXPECT_NEAR(paced.rows.back().internal_energy, slow.rows.back().internal_energy,
              0.02 * slow.rows.back().internal_energy);
  EXPECT_NEAR(paced.rows.back().friction_loss, slow.rows.back().friction_loss, 0.03 * slow.rows.back().friction_loss);
  const results::Quality quality = results::assess_quality(paced.rows, paced.outcome, 0.12);
  EXPECT_TRUE(quality.quasi_static) << quality.verdict;
}

TEST(AdaptedPace, GivenAShortTest_ThenTheLoopFollowsTheGrip) {
  // One stitch, which bears from the start on: a loop swings about once within 1 % of strain at the usual pace.
  model::Case input = model::example_case();
  input.fabric.wales = 1;
  input.fabric.courses = 1;
  input.test.strain = 0.004;
  const model::Model model = model::build_model(input);
  const Simulation paced = run(model, true);
  const results::Quality quality = results::assess_quality(paced.rows, paced.outcome, 0.12);
  EXPECT_TRUE(quality.quasi_static) << quality.verdict;
  EXPECT_LT(*quality.kinetic_ratio, 0.005);
}

TEST(SelectiveMass, GivenTheSamePace_ThenStepsAreLongerTheCurveIsThatOfLumpedMassesAndTheEnergyBalances) {
  const model::Model model = small_fabric();
  const Simulation lumped = run(model, false);
  const Simulation selective = run(model, false, 1, true);
  EXPECT_LT(selective.outcome.steps, 0.6 * static_cast<double>(lumped.outcome.steps));
  for (const double strain : {0.1, 0.12, 0.14}) {
    EXPECT_NEAR(selective.force_at(strain), lumped.force_at(strain), 0.01 * lumped.force_at(strain)) << strain;
  }
  const model::HistoryRow& last = selective.rows.back();
  EXPECT_NEAR(last.external_work, lumped.rows.back().external_work, 0.01 * last.external_work);
  const results::Quality quality = results::assess_quality(selective.rows, selective.outcome, 0.12);
  EXPECT_LT(*quality.energy_balance, 2e-3);
}

TEST(SelectiveMass, GivenTiesOrStrengths_ThenMassesStayLumped) {
  model::Model model = small_fabric();
  EXPECT_GT(solve::selective_length(model), 0);
  model.strengths[0] = 1;
  EXPECT_EQ(solve::selective_length(model), 0);
  model.strengths.clear();
  model.ties.push_back({});
  EXPECT_EQ(solve::selective_length(model), 0);
}

TEST(AdaptedPace, GivenItsChangingSpeed_ThenRowsAndFramesAreEvenInStrainAndTimeIsTheSimulated) {
  const Simulation paced = run(small_fabric(), true);
  ASSERT_EQ(paced.rows.size(), kRows + 1U);
  for (std::size_t i = 0; i < paced.rows.size(); ++i) {
    EXPECT_NEAR(paced.rows[i].strain, kStrain * static_cast<double>(i) / kRows, 1e-5);
  }
  for (std::size_t i = 1; i < paced.rows.size(); ++i) EXPECT_GT(paced.rows[i].time, paced.rows[i - 1].time);
  ASSERT_EQ(paced.frames.size(), 3U);
  EXPECT_NEAR(paced.frames[1].history.strain, 0.08, 1e-5);
}

TEST(AdaptedPace, GivenTheSameModelTwice_ThenBothRunsAgreeToTheLastBit) {
  const model::Model model = small_fabric();
  const Simulation one = run(model, true);
  const Simulation other = run(model, true);
  EXPECT_EQ(one.outcome.steps, other.outcome.steps);
  EXPECT_EQ(one.rows.back().time, other.rows.back().time);
  EXPECT_EQ(one.rows.back().force_top, other.rows.back().force_top);
  EXPECT_EQ(one.rows.back().external_work, other.rows.back().external_work);
}

}  // namespace
}  // namespace knitmech
