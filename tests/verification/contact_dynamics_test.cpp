// Beams in contact: energy of a collision, stick and slip at the Coulomb limit.

#include <gtest/gtest.h>

#include <cmath>

#include "../support/beam_case.h"
#include "../support/relax.h"
#include "contact/yarn_contact.h"

namespace knitmech {
namespace {

constexpr double kDiameter = 0.12;

struct Pair {
  model::Model model;
  beam::Elements elements;
  beam::NodalInertia inertia;
  contact::YarnContact contact;
  model::State state;
  model::NodalLoads loads;
  beam::ElementWork work;
  double step;

  Pair(const std::vector<std::vector<Eigen::Vector3d>>& yarns, double friction)
      : model(model_of(yarns, friction)),
        elements(beam::make_elements(model, 1.0, 0.0)),
        inertia(beam::lump_inertia(elements, 1.0)),
        contact(contact::make_contact_elements(model)),
        state(test::state_of(model)),
        loads(model.nodes.size()),
        work(model.nodes.size()),
        step(0.4 * 2 / std::sqrt(inertia.highest_frequency_squared)) {}

  static model::Model model_of(const std::vector<std::vector<Eigen::Vector3d>>& yarns, double friction) {
    model::Model model =
        test::yarns_through(yarns, test::section(19.2265, 6.17, 0.0173039, 0.0124488, 1.29e-11, kDiameter));
    model.friction = friction;
    model.contact_stiffness = 16;
    return model;
  }

  void advance(const test::ExtraLoads& extra) {
    forces(step);
    extra(state, loads);
    solve::integrate(inertia, loads, {step, step}, 0.0, state);
  }
  void forces(double since) {
    beam::set_internal_force(elements, state, since, work, loads);
    contact.add_forces(state, since, loads);
  }
  /// Stored, moving and lost [mJ].
  [[nodiscard]] double energy() {
    return beam::strain_energy(elements, state) + solve::kinetic_energy(inertia, loads, {step, step}, state) +
           contact.energy() + contact.friction_loss();
  }
};

const test::ExtraLoads kNothing = [](const model::State&, model::NodalLoads&) {};

TEST(Collision, GivenABeamThatIsThrownOnABeam_ThenEnergyAndMomentumAreKept) {
  for (const double friction : {0.0, 0.3}) {
    Pair pair({test::straight({-3, 0, 0}, {3, 0, 0}, 12), test::straight({0.13, -3, 0.3}, {0.13, 3, 0.3}, 12)},
              friction);
    for (std::size_t i = 13; i < 26; ++i) pair.state.velocity.set(i, {500, 0, -2000});  // mm/s, aslant
    const auto momentum = [&] {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < 26; ++i) sum += pair.inertia.mass[i] * test::vector_at(pair.state.velocity, i);
      return sum;
    };
    const Eigen::Vector3d momentum_before = momentum();
    pair.forces(0);
    const double energy_before = pair.energy();
    bool touched = false;
    double largest_error = 0;
    for (int i = 0; i < 4000; ++i) {
      pair.advance(kNothing);
      if (i % 20 != 0) continue;
      pair.forces(0);
      touched = touched || pair.contact.n_contacts() > 0;
      largest_error = std::max(largest_error, std::abs(pair.energy() - energy_before));
    }
    EXPECT_TRUE(touched);
    EXPECT_LT(largest_error, 0.01 * energy_before) << "friction " << friction;
    EXPECT_LT((momentum() - momentum_before).norm(), 1e-9 * momentum_before.norm());
    EXPECT_EQ(pair.contact.friction_loss() > 0, friction > 0);
    EXPECT_FALSE(pair.contact.lost_crossing().has_value());
  }
}

constexpr double kFriction = 0.3;
constexpr double kPressure = 0.01;       // N
constexpr double kBlockMass = 1.29e-11;  // t, of 1 mm of yarn
constexpr double kPullTime = 1e-4;       // s

struct Pulled {
  double moved;         ///< [mm]
  double acceleration;  ///< [mm/s^2], over the second half of the pull
};

/// A block (one element) pressed on a fixed yarn and pulled along x by a force that grows to a share of mu N over the
/// first half of the time and stays.
Pulled pull_block(double share) {
  Pair pair({test::straight({-2, 0, 0}, {2, 0, 0}, 5), test::straight({0, -0.5, kDiameter}, {0, 0.5, kDiameter}, 1)},
            kFriction);
  const long settle = 20000;  // pressed first, with damping, until it rests; then pulled
  const long half = std::lround(0.5 * kPullTime / pair.step);
  double start = 0;
  double speed_at_half = 0;
  for (long i = 0; i < settle + 2 * half; ++i) {
    if (i == settle) start = pair.state.position.x[6];
    if (i == settle + half) speed_at_half = pair.state.velocity.x[6];
    const double pull =
        i < settle ? 0 : share * std::min(1.0, static_cast<double>(i - settle) / static_cast<double>(half));
    pair.advance([&](const model::State& state, model::NodalLoads& loads) {
      for (std::size_t node = 0; node < 6; ++node) test::clamp(loads, node);
      for (const std::size_t node : {6U, 7U}) {
        loads.moment.set(node, {0, 0, 0});
        loads.force.z[node] -= 0.5 * kPressure;
        loads.force.x[node] += 0.5 * pull * kFriction * kPressure;
        if (i < settle) loads.force.add(node, (-0.02 * pair.inertia.mass[node] / pair.step) * state.velocity.at(node));
      }
    });
  }
  return {pair.state.position.x[6] - start,
          (pair.state.velocity.x[6] - speed_at_half) / (static_cast<double>(half) * pair.step)};
}

TEST(StickSlip, GivenAPullBelowTheCoulombLimit_ThenTheBlockSticksButForItsElasticSlip) {
  const Pulled block = pull_block(0.95);
  const double elastic = 0.95 * kFriction * kPressure / 16;  // mm, the stick's stiffness is that of the contact
  EXPECT_NEAR(block.moved, elastic, 0.05 * elastic);
}

TEST(StickSlip, GivenAPullAboveTheCoulombLimit_ThenTheBlockAcceleratesWithTheRest) {
  const double expected = 0.5 * kFriction * kPressure / kBlockMass;
  EXPECT_NEAR(pull_block(1.5).acceleration, expected, 0.01 * expected);
}

}  // namespace
}  // namespace knitmech
