// How fast the grip moves, given the energies of a fabric: made up here, so that what is right is known.

#include "solve/pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "solve/constants.h"

namespace knitmech::solve {
namespace {

constexpr double kStep = 5e-6;
/// 5 mm/s, 77 mm, to 42 %, and mass and bending energy of the main example.
const PaceScale kScale{5, 77, 0.42, 9e-6, 0.54};
const double kCalm = kCalmPace * kScale.speed;

/// A run in which the energies follow from displacement and speed.
struct MadeUpRun {
  Pace pace{kScale};
  std::vector<double> speeds;
  double largest_acceleration = 0, largest_deceleration = 0;

  void pull(double to_strain, const std::function<PaceSignals(const PaceState&)>& fabric) {
    for (long i = 0; pace.state().displacement < to_strain * kScale.gauge_length; ++i) {
      if (i > 0 && i % kPaceInterval == 0) pace.look(fabric(pace.state()));
      const double before = pace.state().speed;
      speeds.push_back(pace.advance(kStep, kStep));
      largest_acceleration = std::max(largest_acceleration, (speeds.back() - before) / kStep);
      largest_deceleration = std::max(largest_deceleration, (before - speeds.back()) / kStep);
    }
  }
};

/// Kinetic energy of an even stretch, and stray energy as a share of it.
PaceSignals signals(const PaceState& state, double internal, double stray_share, double force) {
  const double even = kScale.mass * state.speed * state.speed / 6;
  return {internal, even * (1 + stray_share), even * stray_share, force};
}

/// Bears nothing yet.
PaceSignals slack(const PaceState& state) {
  return signals(state, 1e-6, 0.02, 1e-6);
}

/// Bears ever more, from kTautEnergy on as the sixth power of strain.
PaceSignals taut(const PaceState& state) {
  const double strain = state.displacement / kScale.gauge_length;
  const double internal = kTautEnergy * kScale.bending * std::pow(strain / 0.1, 6);
  return signals(state, internal, 0.02, 6 * internal / state.displacement);
}

TEST(Pace, GivenAFabricThatBearsNothing_ThenTheGripKeepsItsCalmPace) {
  MadeUpRun run;
  run.pull(0.15, slack);
  EXPECT_DOUBLE_EQ(run.pace.state().speed, kCalm);
  EXPECT_LE(*std::max_element(run.speeds.begin(), run.speeds.end()), kCalm * (1 + 1e-12));
}

TEST(Pace, GivenTheStart_ThenTheGripGainsItsPaceEvenlyWithinTheStartStrain) {
  MadeUpRun run;
  run.pull(kStartStrain, slack);
  EXPECT_DOUBLE_EQ(run.pace.state().speed, kCalm);
  EXPECT_NEAR(run.largest_acceleration, kCalm * kCalm / (kStartStrain * kScale.gauge_length), 1e-6);
}

TEST(Pace, GivenAFabricThatBears_ThenTheSpeedGrowsWithTheRootOfItsEnergyAndLagsByItsMemoryOnly) {
  MadeUpRun run;
  run.pull(0.2, taut);
  // The energy that is seen is that of the last look; kCalmPace is the speed at kTautEnergy, reached at 10 % strain.
  EXPECT_NEAR(run.pace.state().speed, kCalm * std::pow(2.0, 3), 0.05 * kCalm * 8);
}

TEST(Pace, GivenASnap_ThenTheGripSlowsDownToItsCalmPaceWithinOnePercentOfStrain) {
  MadeUpRun run;
  run.pull(0.2, taut);
  const double fast = run.pace.state().speed;
  ASSERT_GT(fast, 7 * kCalm);
  // When a tenth of the strain energy has turned into stray motion that nothing damps:
  const auto snapped = [](const PaceState& state) {
    PaceSignals now = taut(state);
    now.stray = 0.1 * now.internal;
    now.kinetic += now.stray;
    return now;
  };
  run.pull(0.21, snapped);
  EXPECT_LT(run.pace.state().speed, 1.05 * kCalm);
  // Then, when all is calm again, it regains its speed.
  run.pull(0.3, taut);
  EXPECT_GT(run.pace.state().speed, fast);
}

TEST(Pace, GivenTheJudgedPartOfATest_ThenKineticOverStrainEnergyTendsToItsGoal) {
  // Given a fabric that is still below kTautEnergy there; at the calm pace the ratio would be 0.15.
  const double internal = kScale.mass * kCalm * kCalm / 6 / 0.15;
  const auto fabric = [&](const PaceState& state) { return signals(state, internal, 0.01, 1e-3); };
  MadeUpRun run;
  run.pull(0.4 * kScale.strain, fabric);
  EXPECT_DOUBLE_EQ(run.pace.state().speed, kCalm);
  run.pull(0.7 * kScale.strain, fabric);
  const PaceSignals now = fabric(run.pace.state());
  EXPECT_NEAR(now.kinetic / now.internal, kKineticGoal, 0.05 * kKineticGoal);
}

TEST(Pace, GivenAFabricThatNeverComesToRest_ThenTheGripIsNeverSlowerThanTheSlowestPace) {
  MadeUpRun run;
  run.pull(0.3, [](const PaceState&) { return PaceSignals{1, 10, 10, 0.1}; });
  EXPECT_DOUBLE_EQ(run.pace.state().speed, kSlowestPace * kScale.speed);
}

TEST(Pace, GivenSignalsThatJump_ThenTheInertiaOfAccelerationStaysWithinItsShareOfTheForce) {
  // Given a force of 0.05 N, and a fabric that is calm for 500 looks and far from it for the next 500.
  constexpr double kForce = 0.05;
  int looks = 0;
  const auto fabric = [&](const PaceState&) {
    const double stray = ++looks / 500 % 2 == 0 ? 1e-6 : 1.0;
    return PaceSignals{1, stray, stray, kForce};
  };
  MadeUpRun run;
  run.pull(kStartStrain, slack);
  run.largest_acceleration = run.largest_deceleration = 0;
  run.pull(0.2, fabric);
  EXPECT_GT(run.largest_acceleration, 0);
  EXPECT_GT(run.largest_deceleration, 0);
  EXPECT_LE(run.largest_acceleration, kSpeedingUpForce * kForce / kScale.mass * (1 + 1e-6));
  EXPECT_LE(run.largest_deceleration, kBrakingForce * kForce / kScale.mass * (1 + 1e-6));
}

TEST(Pace, GivenTheSameSignalsTwice_ThenBothRunsAgreeToTheLastBit) {
  MadeUpRun one, other;
  one.pull(0.2, taut);
  other.pull(0.2, taut);
  EXPECT_EQ(one.speeds, other.speeds);
}

}  // namespace
}  // namespace knitmech::solve
