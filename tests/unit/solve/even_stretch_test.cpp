#include "solve/even_stretch.h"

#include <gtest/gtest.h>

#include "../../support/pulled_yarn.h"
#include "solve/integrate.h"
#include "solve/selective_mass.h"

namespace knitmech {
namespace {

constexpr double kStep = 1e-5;

/// Eleven free nodes of different masses along y, without any force between them; node i has the share i / 10.
struct Bench {
  model::Model model = test::pulled_yarn(19, 0.1, 5, 0);
  beam::NodalInertia inertia{{}, std::vector<double>(11, 1e-9), 0, {}};
  model::State state = test::state_of(model);

  /// \param relative_mass of every element [t]
  explicit Bench(double relative_mass = 0) {
    for (int i = 0; i < 11; ++i) inertia.mass.push_back(1e-6 * (1 + i % 3));
    if (relative_mass == 0) return;
    inertia.relative_mass.assign(11, relative_mass);
    inertia.relative_mass.back() = 0;
  }
  /// Half a step after the state's forces, when velocities are those that the forces led to.
  [[nodiscard]] double kinetic() const { return solve::kinetic_energy(inertia, model::NodalLoads(11), {}, state); }
  void step(solve::EvenStretch& stretch, double speed, double acceleration) {
    const std::vector<char> free(11);
    model::NodalLoads loads(11);
    stretch.apply(speed, acceleration, kStep, state, loads);
    solve::SelectiveMass(inertia, {free, free}).share(loads);
    solve::integrate(inertia, loads, {kStep, kStep}, 0.0, state);
  }
};

TEST(EvenStretch, GivenAGripThatGainsSpeed_ThenEveryNodeGainsItsShareAndTheWorkIsTheKineticEnergy) {
  for (const double relative_mass : {0.0, 4e-6}) {
    Bench bench(relative_mass);
    solve::EvenStretch stretch(bench.model, bench.inertia);
    for (int i = 0; i < 100; ++i) bench.step(stretch, 2000 * kStep * i, 2000);
    for (std::size_t i = 0; i < 11; ++i) {
      EXPECT_NEAR(bench.state.velocity.y[i], 0.1 * static_cast<double>(i) * 2000 * 100 * kStep, 1e-12) << i;
      EXPECT_EQ(bench.state.velocity.x[i], 0);
    }
    EXPECT_NEAR(stretch.work(), bench.kinetic(), 1e-12 * bench.kinetic());
    EXPECT_NEAR(stretch.stray_energy(bench.kinetic(), 2, bench.state), 0, 1e-12 * bench.kinetic());
  }
}

TEST(EvenStretch, GivenAGripThatBrakesAnEvenStretch_ThenTheWorkComesBackAndNothingIsLost) {
  for (const double relative_mass : {0.0, 4e-6}) {
    Bench bench(relative_mass);
    solve::EvenStretch stretch(bench.model, bench.inertia);
    for (int i = 0; i < 100; ++i) bench.step(stretch, 2000 * kStep * i, 2000);
    const double gained = stretch.work();
    for (int i = 0; i < 50; ++i) bench.step(stretch, 2 - 2000 * kStep * i, -2000);
    EXPECT_NEAR(stretch.work(), gained / 4, 1e-9 * gained);
    EXPECT_NEAR(stretch.damping_loss(), 0, 1e-9 * gained);
  }
}

TEST(EvenStretch, GivenStrayMotionAndAGripThatBrakesToHalfItsSpeed_ThenItHalvesAndWhatVanishedIsTheLoss) {
  for (const double relative_mass : {0.0, 4e-6}) {
    Bench bench(relative_mass);
    solve::EvenStretch stretch(bench.model, bench.inertia);
    for (int i = 0; i < 100; ++i) bench.step(stretch, 2000 * kStep * i, 2000);
    // Given a node that a snap has thrown sideways and forward, 3 and 4 mm/s relative to the stretch.
    bench.state.velocity.x[5] += 3;
    bench.state.velocity.y[5] += 4;
    const double stray = 0.5 * (bench.inertia.mass[5] + 2 * relative_mass) * 25;
    EXPECT_NEAR(stretch.stray_energy(bench.kinetic(), 2, bench.state), stray, 1e-9 * stray);
    for (int i = 0; i < 500; ++i) bench.step(stretch, 2 - 200 * kStep * i, -200);
    EXPECT_NEAR(bench.state.velocity.x[5], 1.5, 1e-3);
    EXPECT_NEAR(stretch.stray_energy(bench.kinetic(), 1, bench.state), stray / 4, 2e-3 * stray);
    EXPECT_NEAR(stretch.damping_loss(), 0.75 * stray, 2e-3 * stray);
  }
}

}  // namespace
}  // namespace knitmech
