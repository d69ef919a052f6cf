#include "solve/grips.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "../../support/beam_case.h"

namespace knitmech {
namespace {

/// One yarn along y of two elements; the first node is held, the last driven.
model::Model pulled_yarn(model::Grips grips) {
  model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {0, 2, 0}, 2)}, test::section(19, 6, 0.017, 0.012, 1e-9));
  model.node_sets[model::kBottomFeet] = {0};
  model.node_sets[model::kTopHeads] = {2};
  model.test.grips = grips;
  model.test.gauge_length = 2;
  model.test.strain = 0.1;
  model.test.speed = 5;
  model.test.ramp = 0.01;
  return model;
}

struct Bench {
  model::Model model;
  beam::NodalInertia inertia;
  model::State state;
  solve::Grips grips;
  solve::SelectiveMass masses;

  explicit Bench(model::Grips kind, std::vector<double> relative_mass = {})
      : model(pulled_yarn(kind)),
        inertia{{1e-6, 2e-6, 1e-6}, {1e-8, 1e-8, 1e-8}, 0, std::move(relative_mass)},
        state(test::state_of(model)),
        grips(model),
        masses(inertia, solve::GivenMotion::by_grips(model)) {}

  /// One step under loads that the fabric puts on the grips.
  void step(double h, Vector3 on_held, Vector3 on_driven) {
    model::NodalLoads loads(3);
    loads.force.set(0, on_held);
    loads.force.set(2, on_driven);
    loads.moment.set(2, {1, 2, 3});
    const double speed = (model.test.displacement(state.time + h) - model.test.displacement(state.time)) / h;
    grips.apply(inertia, masses, {h, h}, 0.0, state, speed, loads);
    solve::integrate(inertia, loads, {h, h}, 0.0, state);
  }
};

TEST(Grips, GivenAnyLoads_ThenTheHeldNodeStaysAndTheDrivenOneFollowsTheTestExactly) {
  Bench bench(model::Grips::clamped);
  for (int i = 0; i < 100; ++i) bench.step(1e-4 * (1 + i % 3), {1, 2, 3}, {-4, -5 + 0.1 * i, 6});
  EXPECT_NEAR(test::vector_at(bench.state.position, 0).norm(), 0.0, 1e-15);
  EXPECT_NEAR(bench.state.position.y[2] - 2, bench.model.test.displacement(bench.state.time), 1e-14);
  EXPECT_EQ(bench.state.position.x[2], 0.0);
  EXPECT_EQ(bench.state.rotation.w[2], 1.0);
}

TEST(Grips, GivenSlidingGrips_ThenTheDrivenNodeIsFreeAcrossThePullOnly) {
  Bench bench(model::Grips::sliding);
  for (int i = 0; i < 10; ++i) bench.step(1e-4, {0, 0, 0}, {1e-6, -5, -1e-6});
  EXPECT_GT(bench.state.position.x[2], 0.0);
  EXPECT_LT(bench.state.position.z[2], 0.0);
  EXPECT_EQ(bench.state.rotation.w[2], 1.0);
  EXPECT_NEAR(bench.state.position.y[2] - 2, bench.model.test.displacement(bench.state.time), 1e-14);
}

TEST(Grips, GivenASteadyPullOfTheFabric_ThenBothGripsReportItAndTheWorkIsForceTimesDisplacement) {
  Bench bench(model::Grips::clamped);
  for (int i = 0; i < 200; ++i) bench.step(1e-4, {0, 3, 0}, {0, -3, 0});  // past the ramp
  EXPECT_NEAR(bench.grips.force_bottom(), 3.0, 1e-12);
  EXPECT_NEAR(bench.grips.force_top(), 3.0, 1e-9);
  const double kinetic = 0.5 * 1e-6 * 25;         // the grip moves a mass too
  const double half_a_step = 0.5 * 3 * 5 * 1e-4;  // work reaches to the last velocity, half a step behind
  EXPECT_NEAR(bench.grips.work() + half_a_step, 3 * bench.model.test.displacement(bench.state.time) + kinetic, 1e-6);
}

TEST(Grips, GivenRelativeMasses_ThenCourseAndWorkAreExactAndBothGripsTogetherAreTheRateOfTheMomentum) {
  Bench bench(model::Grips::clamped, {3e-6, 5e-6, 0});
  const auto momentum = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += bench.inertia.mass[i] * bench.state.velocity.y[i];
    return sum;
  };
  const auto kinetic = [&] { return solve::kinetic_energy(bench.inertia, model::NodalLoads(3), {}, bench.state); };
  for (int i = 0; i < 300; ++i) {
    const double before = momentum();
    const double h = 1e-4 * (1 + i % 3);
    bench.step(h, {1, 2, 3}, {-4, -5 + 0.1 * i, 6});
    const double from_fabric = 2 - 5 + 0.1 * i;
    EXPECT_NEAR(bench.grips.force_top() - bench.grips.force_bottom() + from_fabric, (momentum() - before) / h, 1e-9);
    EXPECT_NEAR(bench.state.position.y[2] - 2, bench.model.test.displacement(bench.state.time), 1e-13);
  }
  EXPECT_NEAR(test::vector_at(bench.state.position, 0).norm(), 0.0, 1e-15);
  EXPECT_GT(bench.state.velocity.y[1], 0);  // dragged along by its neighbour alone
  // Without loads of the fabric, all work of the grip is kinetic energy.
  Bench unloaded(model::Grips::clamped, {3e-6, 5e-6, 0});
  for (int i = 0; i < 300; ++i) unloaded.step(1e-4, {0, 0, 0}, {0, 0, 0});
  bench = std::move(unloaded);
  EXPECT_NEAR(bench.grips.work(), kinetic(), 1e-9 * kinetic());
}

TEST(Grips, GivenLoadsOnGrips_ThenClearingThemLeavesOnlyTheFreeNodes) {
  Bench bench(model::Grips::sliding);
  model::NodalLoads loads(3);
  for (std::size_t i = 0; i < 3; ++i) {
    loads.force.set(i, {1, 1, 1});
    loads.moment.set(i, {1, 1, 1});
  }
  bench.grips.clear_loads(loads);
  EXPECT_EQ(test::vector_at(loads.force, 0).norm(), 0.0);
  EXPECT_EQ(test::vector_at(loads.force, 1), Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(test::vector_at(loads.force, 2), Eigen::Vector3d(1, 0, 1));
  EXPECT_EQ(test::vector_at(loads.moment, 2).norm(), 0.0);
}

}  // namespace
}  // namespace knitmech
