// Beams in motion without contact: energy and the stable step.

#include <gtest/gtest.h>

#include <cmath>

#include "../support/beam_case.h"
#include "../support/verification.h"
#include "beam/internal_force.h"
#include "beam/nodal_inertia.h"
#include "solve/integrate.h"

namespace knitmech {
namespace {

struct FreeBeam {
  model::Model model = test::yarns_through({test::straight({0, 0, 0}, {10, 0, 0}, 20)},
                                           test::section(19.2265, 6.17, 0.0173039, 0.0124488, 1.29e-11));
  beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  beam::NodalInertia inertia = beam::lump_inertia(elements, 1.0);
  model::State state = test::state_of(model);
  model::NodalLoads loads{model.nodes.size()};
  beam::ElementWork work{model.nodes.size()};
  double step = 0;

  explicit FreeBeam(double share_of_limit) : step(share_of_limit * 2 / std::sqrt(inertia.highest_frequency_squared)) {}
  void advance() {
    beam::set_internal_force(elements, state, step, work, loads);
    solve::integrate(inertia, loads, {step, step}, 0.0, state);
  }
  [[nodiscard]] double energy() {
    beam::set_internal_force(elements, state, 0.0, work, loads);
    return beam::strain_energy(elements, state) + solve::kinetic_energy(inertia, loads, {step, step}, state);
  }
};

TEST(FreeFlight, GivenABeamThatTumblesAndBends_ThenItsEnergyAndMomentumStayOver1e5Steps) {
  FreeBeam beam(0.9);
  const std::size_t n = beam.model.nodes.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(n - 1);
    beam.state.velocity.set(i, {0, 4e4 * std::sin(6 * s), 3e4 * (s - 0.5)});  // mm/s: bends by its own length
  }
  const auto momentum = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < n; ++i) sum += beam.inertia.mass[i] * test::vector_at(beam.state.velocity, i);
    return sum;
  };
  const Eigen::Vector3d momentum_before = momentum();
  beam.advance();
  const double energy_before = beam.energy();
  double largest_bending = 0;
  for (int i = 0; i < 100000; ++i) {
    beam.advance();
    if (i % 1000 == 0) largest_bending = std::max(largest_bending, beam::strain_energy(beam.elements, beam.state));
  }
  EXPECT_GT(largest_bending, 0.05 * energy_before);  // it does bend
  test::verify({.chapter = "free flight",
                .of = "100000 steps",
                .quantity = "energy [uJ]",
                .source = "energy at the start",
                .reference = 1e3 * energy_before,
                .computed = 1e3 * beam.energy(),
                .tolerance = 0.01});
  test::verify({.chapter = "free flight",
                .of = "100000 steps",
                .quantity = "momentum gained over momentum at the start [-]",
                .source = "conservation",
                .computed = (momentum() - momentum_before).norm() / momentum_before.norm(),
                .tolerance = 1e-9,
                .scale = 1});
}

TEST(StableStep, GivenAStepBelowAndOneAboveTheLimit_ThenTheFirstStaysCalmAndTheSecondRunsAway) {
  for (const double share : {0.98, 1.05}) {
    FreeBeam beam(share);
    for (std::size_t i = 0; i < beam.model.nodes.size(); ++i) {
      beam.state.velocity.x[i] = i % 2 == 0 ? 1e-3 : -1e-3;  // the mesh's fastest axial vibration
    }
    double largest = 0;
    for (int i = 0; i < 3000; ++i) {
      beam.advance();
      largest = std::max(largest, std::abs(beam.state.velocity.x[10]));
    }
    if (share < 1) {
      EXPECT_LT(largest, 1e-2);
    } else {
      EXPECT_FALSE(largest < 1e2);
    }
  }
}

TEST(Vibration, GivenAYarnHeldAtOneEnd_ThenItsLowestAxialPeriodIsFourCrossingsOfTheWave) {
  FreeBeam beam(0.5);
  const std::size_t tip = beam.model.nodes.size() - 1;
  for (std::size_t i = 0; i <= tip; ++i) {
    beam.state.velocity.x[i] = std::sin(std::acos(-1.0) / 2 * static_cast<double>(i) / static_cast<double>(tip));
  }
  // From rest length with this velocity, the tip comes back through zero after half a period: 2 L / c.
  const double expected = 2 * 10 / std::sqrt(19.2265 / 1.29e-11);
  double before = 0;
  double crossing = 0;
  for (int i = 0; i < 100000 && crossing == 0; ++i) {
    beam::set_internal_force(beam.elements, beam.state, beam.step, beam.work, beam.loads);
    beam.loads.force.set(0, {0, 0, 0});
    beam.loads.moment.set(0, {0, 0, 0});
    solve::integrate(beam.inertia, beam.loads, {beam.step, beam.step}, 0.0, beam.state);
    const double moved = beam.state.position.x[tip] - 10;
    if (before > 0 && moved <= 0) crossing = beam.state.time + beam.step * moved / (before - moved);
    before = moved;
  }
  test::verify({.chapter = "vibration",
                .of = "20 elements",
                .quantity = "half the lowest axial period [us]",
                .source = "2 L / c",
                .reference = 1e6 * expected,
                .computed = 1e6 * crossing,
                .tolerance = 0.002});
}

}  // namespace
}  // namespace knitmech
