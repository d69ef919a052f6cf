#include "solve/simulate.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "../../support/pulled_yarn.h"

namespace knitmech {
namespace {

constexpr double kAxial = 19.0;
constexpr double kLength = test::kPulledLength;

/// Force and energy are known.
model::Model straight_yarn(double strain) {
  return test::pulled_yarn(kAxial, strain, 5, 0.005);
}

struct Heard {
  std::vector<model::HistoryRow> rows;
  std::vector<model::Frame> frames;
  solve::SimulationCallbacks callbacks{[this](const model::HistoryRow& row) { rows.push_back(row); },
                                       [this](const model::Frame& frame) { frames.push_back(frame); },
                                       {}};
};

solve::SimulationSettings settings(int history_points, std::vector<double> frames_at) {
  solve::SimulationSettings settings;
  settings.mass_scaling = 100;
  settings.history_points = history_points;
  settings.frames_at = std::move(frames_at);
  return settings;
}

TEST(Simulate, GivenAStraightYarn_ThenForceAndEnergyAreThoseOfABar) {
  const double strain = 0.01;
  Heard heard;
  const model::RunOutcome outcome = solve::simulate(straight_yarn(strain), settings(50, {}), heard.callbacks);
  EXPECT_EQ(outcome.status, model::RunStatus::completed) << outcome.reason;
  const model::HistoryRow& last = heard.rows.back();
  EXPECT_NEAR(last.strain, strain, 1e-5);
  EXPECT_NEAR(last.internal_energy, 0.5 * kAxial * strain * strain * kLength, 1e-3 * last.internal_energy);
  EXPECT_NEAR(last.external_work, last.internal_energy, 2e-3 * last.internal_energy);
  EXPECT_NEAR(last.force_top, kAxial * strain, 2e-3 * last.force_top);
  EXPECT_NEAR(last.force_bottom, last.force_top, 5e-3 * last.force_top);
  EXPECT_NEAR(heard.frames.back().axial_force[4], kAxial * strain, 2e-3 * kAxial * strain);
}

TEST(Simulate, GivenAFrame_ThenTheStretchEnergyOfItsElementsIsThatOfItsRow) {
  // Reference: the sum over the elements, by another loop; and of a straight bar all of its strain energy.
  Heard heard;
  static_cast<void>(solve::simulate(straight_yarn(0.01), settings(20, {0.004}), heard.callbacks));
  ASSERT_EQ(heard.frames.size(), 3U);
  for (const model::Frame& frame : heard.frames) {
    double sum = 0;
    for (const double energy : frame.stretch_energy) sum += energy;
    EXPECT_NEAR(frame.history.stretch_energy, sum, 1e-12 * sum);
    EXPECT_NEAR(frame.history.stretch_energy, frame.history.internal_energy, 1e-9 * frame.history.internal_energy);
  }
  EXPECT_GT(heard.rows.back().stretch_energy, 0);
}

TEST(Simulate, GivenFramesAndHistoryPoints_ThenEachIsReportedWhereItWasAskedFor) {
  Heard heard;
  static_cast<void>(solve::simulate(straight_yarn(0.01), settings(20, {0.0025, 0.00333, 0.05}), heard.callbacks));
  ASSERT_EQ(heard.frames.size(), 4U);  // start, two on the way, end; 0.05 is beyond the test
  EXPECT_NEAR(heard.frames[0].history.strain, 0.0, 1e-15);
  EXPECT_NEAR(heard.frames[1].history.strain, 0.0025, 1e-5);
  EXPECT_NEAR(heard.frames[2].history.strain, 0.00333, 1e-5);
  EXPECT_NEAR(heard.frames[3].history.strain, 0.01, 1e-5);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(heard.frames[static_cast<std::size_t>(i)].index, i);
  // The start, twenty points, and the frame that lies on none of them.
  ASSERT_EQ(heard.rows.size(), 22U);
  for (std::size_t i = 1; i < heard.rows.size(); ++i) EXPECT_GT(heard.rows[i].time, heard.rows[i - 1].time);
}

TEST(Simulate, GivenFewRows_ThenTheirForcesAreNoLaterThanTheirStrains) {
  Heard heard;
  static_cast<void>(solve::simulate(straight_yarn(0.01), settings(5, {0.005}), heard.callbacks));
  ASSERT_EQ(heard.rows.size(), 7U);
  for (const model::HistoryRow& row : heard.rows) {
    if (row.strain < 0.003) continue;  // the grip gains its speed
    EXPECT_NEAR(row.force_top, kAxial * row.strain, 5e-3 * row.force_top) << row.strain;
  }
}

TEST(Simulate, GivenMoreRowsThanSteps_ThenThereIsOneForEachStepAndAllFramesAreReported) {
  Heard heard;
  const model::RunOutcome outcome =
      solve::simulate(straight_yarn(0.01), settings(1000000, {0.005, 0.0050000001}), heard.callbacks);
  EXPECT_LE(static_cast<long>(heard.rows.size()), outcome.steps + 1);
  EXPECT_GT(outcome.steps, 100);
  EXPECT_EQ(heard.frames.size(), 4U);
  for (std::size_t i = 1; i < heard.rows.size(); ++i) {
    EXPECT_GT(heard.rows[i].strain, heard.rows[i - 1].strain);
    if (heard.rows[i].strain < 0.003) continue;
    EXPECT_GT(heard.rows[i].force_top, 0.5 * kAxial * heard.rows[i].strain);
  }
}

TEST(Simulate, GivenACallerWhoSaysStop_ThenTheRunEndsCleanlyWithALastFrame) {
  Heard heard;
  int asked = 0;
  heard.callbacks.keep_going = [&](const model::HistoryRow&) { return ++asked < 3; };
  const model::RunOutcome outcome = solve::simulate(straight_yarn(0.05), settings(20, {}), heard.callbacks);
  EXPECT_EQ(outcome.status, model::RunStatus::interrupted);
  EXPECT_GT(outcome.steps, 0);
  EXPECT_LT(outcome.strain, 0.05);
  EXPECT_EQ(heard.frames.size(), 2U);
  EXPECT_EQ(heard.rows.back().strain, outcome.strain);
}

TEST(Simulate, GivenSomeoneWhoWatches_ThenTheyGetThePresentStateBesideTheFrames) {
  Heard heard;
  std::vector<model::Frame> views;
  heard.callbacks.wants_view = [&] { return views.size() < 5; };
  heard.callbacks.on_view = [&](model::Frame frame) { views.push_back(std::move(frame)); };
  const model::Model model = straight_yarn(0.01);
  static_cast<void>(solve::simulate(model, settings(4, {}), heard.callbacks));
  ASSERT_EQ(views.size(), 5U);
  EXPECT_EQ(heard.frames.size(), 2U);
  EXPECT_EQ(heard.frames.back().index, 1);
  for (const model::Frame& view : views) {
    EXPECT_EQ(view.index, -1);
    // Reference: the way that the grip has gone.
    const double way = view.points[10].y() - model.nodes[10].y();
    EXPECT_GT(way, 0);
    EXPECT_NEAR(view.history.displacement, way, 1e-9);
    EXPECT_NEAR(view.history.strain, way / kLength, 1e-10);
    EXPECT_GT(view.history.time, 0);
  }
  EXPECT_LT(views.back().history.strain, heard.rows[1].strain);
}

TEST(Simulate, GivenACallerWhoWaitsBeforeTheyAnswer_ThenThatIsNoTimeInTheSolver) {
  using Clock = std::chrono::steady_clock;
  Heard heard;
  Clock::duration waited{};
  heard.callbacks.keep_going = [&](const model::HistoryRow&) {
    const auto start = Clock::now();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    waited += Clock::now() - start;
    return true;
  };
  const auto start = Clock::now();
  const model::RunOutcome outcome = solve::simulate(straight_yarn(0.01), settings(4, {}), heard.callbacks);
  const std::chrono::duration<double> rest = Clock::now() - start - waited;
  EXPECT_EQ(outcome.status, model::RunStatus::completed);
  EXPECT_GT(waited, std::chrono::milliseconds(1));
  EXPECT_GT(outcome.wall_seconds, 0);
  EXPECT_LE(outcome.wall_seconds, rest.count());
}

TEST(Simulate, GivenAnUnstableStep_ThenTheRunFailsWithWhenAndWhatToTryAndKeepsWhatWasComputed) {
  Heard heard;
  solve::SimulationSettings unstable = settings(50, {});
  unstable.step_factor = 3;
  const model::RunOutcome outcome = solve::simulate(straight_yarn(0.05), unstable, heard.callbacks);
  EXPECT_EQ(outcome.status, model::RunStatus::failed);
  EXPECT_NE(outcome.reason.find("% strain"), std::string::npos) << outcome.reason;
  EXPECT_NE(outcome.advice.find("solver.step_factor"), std::string::npos) << outcome.advice;
  EXPECT_FALSE(heard.rows.empty());
  EXPECT_FALSE(heard.frames.empty());
}

TEST(Settings, GivenACase_ThenTheSolverIsToldWhatItSays) {
  model::Case input;
  input.solver.mass_scaling = 42;
  input.solver.bulk_viscosity = 0.01;
  input.solver.mass_damping = 3;
  input.solver.step_factor = 0.7;
  input.output.frames_at = {0.1, 0.2};
  input.output.history_points = 17;
  const solve::SimulationSettings settings = solve::settings_from(input);
  EXPECT_EQ(settings.mass_scaling, 42);
  EXPECT_EQ(settings.bulk_viscosity, 0.01);
  EXPECT_EQ(settings.mass_damping, 3);
  EXPECT_EQ(settings.step_factor, 0.7);
  EXPECT_EQ(settings.frames_at, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(settings.history_points, 17);
}

}  // namespace
}  // namespace knitmech
