// Beams in contact: energy and momentum of a collision, stick and slip at the Coulomb limit.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../support/centrelines.h"
#include "../support/contact_bench.h"
#include "../support/verification.h"
#include "../support/yarn_shape.h"

namespace knitmech {
namespace {

constexpr double kStiffness = 16;  // N/mm
const double kDiameter = test::monofilament().diameter;

// ---- Collisions ----

struct Throw {
  std::string name;
  double angle;              ///< [rad], between the two yarns
  double height;             ///< [mm], of the thrown yarn over the other
  Eigen::Vector3d velocity;  ///< [mm/s]
};

class Collision : public testing::TestWithParam<model::Centreline> {};
KNITMECH_WITH_EVERY_CENTRELINE(Collision);

void throw_yarn_on_yarn(const Throw& flight, double friction, model::Centreline centreline) {
  model::Model model = test::empty_model(test::monofilament(), friction, kStiffness, centreline);
  const Eigen::Vector3d half = 3 * Eigen::Vector3d(std::cos(flight.angle), std::sin(flight.angle), 0);
  const Eigen::Vector3d middle(0.13, 0.04, flight.height);
  test::add_yarn(model, test::straight_shape({-3, 0, 0}, {3, 0, 0}, 12));
  test::add_yarn(model, test::straight_shape(middle - half, middle + half, 12));
  test::ContactBench yarns(model);
  for (std::size_t i = yarns.first_node(1); i <= yarns.last_node(1); ++i) {
    yarns.state.velocity.set(i, {flight.velocity.x(), flight.velocity.y(), flight.velocity.z()});
  }
  const Eigen::Vector3d momentum_before = yarns.momentum();
  yarns.forces(0);
  const double energy_before = yarns.energy();
  double energy_off = energy_before;  // the one that is farthest from the first
  bool touched = false;
  for (int i = 0; i < 4000; ++i) {
    yarns.advance([](const model::State&, model::NodalLoads&) {});
    if (i % 20 != 0) continue;
    yarns.forces(0);
    touched = touched || yarns.contact.n_contacts() > 0;
    const double energy = yarns.energy();
    if (std::abs(energy - energy_before) > std::abs(energy_off - energy_before)) energy_off = energy;
  }
  EXPECT_TRUE(touched);
  EXPECT_EQ(yarns.contact.friction_loss() > 0, friction > 0);
  EXPECT_FALSE(yarns.contact.lost_crossing().has_value());

  const std::string of = flight.name + ", mu = " + (friction > 0 ? "0.3" : "0") + ", " + test::name_of(centreline);
  test::verify({.chapter = "collisions",
                .of = of,
                .quantity = "energy and friction loss when farthest off [uJ]",
                .source = "energy before",
                .reference = 1e3 * energy_before,
                .computed = 1e3 * energy_off,
                .tolerance = 0.01});
  test::verify({.chapter = "collisions",
                .of = of,
                .quantity = "momentum gained over momentum before [-]",
                .source = "conservation",
                .computed = (yarns.momentum() - momentum_before).norm() / momentum_before.norm(),
                .tolerance = 1e-9,
                .scale = 1});
}

TEST_P(Collision, GivenAYarnThatIsThrownOnAYarn_ThenEnergyAndMomentumAreKept) {
  const std::vector<Throw> throws = {{"thrown across, aslant, at 2 m/s", std::numbers::pi / 2, 0.3, {500, 0, -2000}},
                                     {"thrown alongside, at 0.5 m/s", 0.02, 0.3, {0, 0, -500}}};
  for (const Throw& flight : throws) {
    for (const double friction : {0.0, 0.3}) throw_yarn_on_yarn(flight, friction, GetParam());
  }
}

// ---- Stick and slip ----

constexpr double kFriction = 0.3;
constexpr double kPressure = 0.01;  // N
constexpr double kLimit = kFriction * kPressure;

/// A short yarn that lies across a held one and moves as one piece: a rigid block, pressed on by a dead load.
struct Block {
  test::ContactBench yarns;
  double mass = 0;  ///< [t]

  explicit Block(model::Centreline centreline) : yarns(model_of(centreline)) {
    for (std::size_t i = yarns.first_node(1); i <= yarns.last_node(1); ++i) mass += yarns.inertia.mass[i];
  }
  /// Elements of 0.2 mm; no node of the one lies on a node of the other.
  static model::Model model_of(model::Centreline centreline) {
    model::Model model = test::empty_model(test::monofilament(), kFriction, kStiffness, centreline);
    test::add_yarn(model, test::straight_shape({-1.07, 0, 0}, {0.93, 0, 0}, 10));
    test::add_yarn(model, test::straight_shape({0, -0.83, kDiameter}, {0, 0.17, kDiameter}, 5));
    return model;
  }
  [[nodiscard]] Eigen::Vector3d place() const { return test::vector_at(yarns.state.position, yarns.first_node(1)); }
  [[nodiscard]] Eigen::Vector3d velocity() const { return test::vector_at(yarns.state.velocity, yarns.first_node(1)); }
  void set_velocity(const Eigen::Vector3d& velocity) {
    for (std::size_t i = yarns.first_node(1); i <= yarns.last_node(1); ++i) {
      yarns.state.velocity.set(i, {velocity.x(), velocity.y(), velocity.z()});
    }
  }

  /// One step. \param act changes the force on the block, that of contact and pressure, into what is to act [N]
  template <typename Act>
  void advance(const Act& act) {
    yarns.advance([&](const model::State&, model::NodalLoads& loads) {
      const std::size_t first = yarns.first_node(1);
      Eigen::Vector3d force(0, 0, -kPressure);
      for (std::size_t i = first; i <= yarns.last_node(1); ++i) force += test::vector_at(loads.force, i);
      act(force);
      for (std::size_t i = 0; i <= yarns.last_node(1); ++i) {
        test::clamp(loads, i);
        const double share = i < first ? 0 : yarns.inertia.mass[i] / mass;
        loads.force.add(i, share * Vector3{force.x(), force.y(), force.z()});
      }
    });
  }
  /// Mass times the damping that is critical for the block on its contact [N s/mm].
  [[nodiscard]] double critical() const { return 2 * std::sqrt(kStiffness * mass); }
  /// Lets the pressure come on.
  void press() {
    for (int i = 0; i < 2000; ++i) {
      advance([&](Eigen::Vector3d& force) { force -= critical() * velocity(); });
    }
  }
};

Eigen::Vector3d direction(double angle) {
  return {std::cos(angle), std::sin(angle), 0};
}

class StickSlip : public testing::TestWithParam<model::Centreline> {
 protected:
  [[nodiscard]] static std::string here(const std::string& of) { return of + ", " + test::name_of(GetParam()); }
};
KNITMECH_WITH_EVERY_CENTRELINE(StickSlip);

TEST_P(StickSlip, GivenAPullBelowTheCoulombLimitThatTurns_ThenTheBlockSticksAndComesBack) {
  Block block(GetParam());
  block.press();
  const Eigen::Vector3d start = block.place();
  const double pull = 0.95 * kLimit;
  const auto pull_along = [&](double share, double angle) {
    block.advance([&](Eigen::Vector3d& force) {
      force += share * pull * direction(angle) - block.critical() * block.velocity();
    });
  };
  for (int i = 0; i <= 5000; ++i) pull_along(std::min(1.0, i / 4000.0), 0);
  const Eigen::Vector3d pulled = block.place() - start;
  const int turn = 20000;  // steps
  for (int i = 0; i <= 3 * turn; ++i) pull_along(1, 2 * std::numbers::pi * i / turn);
  for (int i = 0; i <= 2000; ++i) pull_along(1, 0);
  test::verify({.chapter = "stick and slip",
                .of = here("pull of 0.95 mu N"),
                .quantity = "elastic slip over the yarn's diameter [-]",
                .source = "none",
                .computed = pulled.norm() / kDiameter,
                .tolerance = 0.01,
                .scale = 1});
  test::verify({.chapter = "stick and slip",
                .of = here("pull of 0.95 mu N that turns three times"),
                .quantity = "creep over the yarn's diameter [-]",
                .source = "none",
                .computed = (block.place() - start - pulled).norm() / kDiameter,
                .tolerance = 1e-5,
                .scale = 1});
}

TEST_P(StickSlip, GivenASteadyPullAboveTheLimit_ThenTheBlockAcceleratesWithTheRest) {
  Block block(GetParam());
  block.press();
  const int half = static_cast<int>(std::lround(5e-5 / block.yarns.step));
  double speed_at_half = 0;
  for (int i = 0; i < 2 * half; ++i) {
    if (i == half) speed_at_half = block.velocity().x();
    const double share = std::min(1.0, static_cast<double>(i) / half);
    block.advance([&](Eigen::Vector3d& force) {
      force.x() += share * 1.5 * kLimit;
      force.z() -= 0.5 * block.critical() * block.velocity().z();
    });
  }
  test::verify({.chapter = "stick and slip",
                .of = here("steady pull of 1.5 mu N"),
                .quantity = "acceleration [m/s^2]",
                .source = "(pull - mu N) / mass",
                .reference = 1e-3 * 0.5 * kLimit / block.mass,
                .computed = 1e-3 * (block.velocity().x() - speed_at_half) / (half * block.yarns.step),
                .tolerance = 0.01});
}

constexpr double kCircle = 0.3;  // mm, five hundred times the elastic slip; leads over many nodes of both yarns

TEST_P(StickSlip, GivenAPullAboveTheLimitThatTurns_ThenTheBlockCirclesAtTheSpeedThatTheBalanceDemands) {
  // On a circle, the pull P leads the velocity by an angle a: P cos(a) = mu N, P sin(a) = m v w.
  Block block(GetParam());
  block.press();
  const double pull = 2 * kLimit;
  const double lead = std::acos(kLimit / pull);
  const double rate = std::sqrt(pull * std::sin(lead) / (block.mass * kCircle));
  const double step = block.yarns.step;
  block.set_velocity(rate * kCircle * direction(-0.5 * rate * step));
  const int turn = static_cast<int>(std::lround(2 * std::numbers::pi / rate / step));
  double mean = 0;
  for (int i = 0; i < turn; ++i) {
    block.advance([&](Eigen::Vector3d& force) {
      force += pull * direction(rate * i * step + lead);
      force.z() -= 0.5 * block.critical() * block.velocity().z();
    });
    mean += block.velocity().head<2>().norm() / turn;
  }
  test::verify({.chapter = "stick and slip",
                .of = here("pull of 2 mu N that turns once"),
                .quantity = "speed on the circle [m/s]",
                .source = "sqrt(pull^2 - (mu N)^2) / (mass * rate)",
                .reference = 1e-3 * rate * kCircle,
                .computed = 1e-3 * mean,
                .tolerance = 0.01});
}

TEST_P(StickSlip, GivenAYarnDrivenOnACircle_ThenTheLossPerTurnIsMuNTimesTheWay) {
  Block block(GetParam());
  block.press();
  const int turn = 40000;  // steps
  const double rate = 2 * std::numbers::pi / (turn * block.yarns.step);
  double loss_before = 0;
  for (int i = 0; i < 2 * turn; ++i) {
    if (i == turn) loss_before = block.yarns.contact.friction_loss();
    const double climb = block.velocity().z();
    block.set_velocity(rate * kCircle * direction(2 * std::numbers::pi * i / turn) + climb * Eigen::Vector3d::UnitZ());
    block.advance([&](Eigen::Vector3d& force) { force = {0, 0, force.z() - 0.1 * block.critical() * climb}; });
  }
  test::verify({.chapter = "stick and slip",
                .of = here("driven round a circle of 0.3 mm"),
                .quantity = "friction loss per turn [uJ]",
                .source = "mu N 2 pi r",
                .reference = 1e3 * kLimit * 2 * std::numbers::pi * kCircle,
                .computed = 1e3 * (block.yarns.contact.friction_loss() - loss_before),
                .tolerance = 0.01});
}

}  // namespace
}  // namespace knitmech
