#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>
#include <random>

#include "../../support/beam_case.h"
#include "beam/elements.h"
#include "beam/internal_force.h"

namespace knitmech {
namespace {

using test::rotation_of;
using test::set_rotation;
using test::turn;
using test::vector_at;

Eigen::Vector3d random_vector(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  const double x = uniform(random);
  const double y = uniform(random);
  const double z = uniform(random);
  return {x, y, z};
}

struct Beam {
  model::Model model;
  beam::Elements elements;
  model::State state;

  explicit Beam(const std::vector<Eigen::Vector3d>& nodes)
      : model(test::yarns_through({nodes}, test::section(19.0, 6.1, 0.0173, 0.0124, 1.3e-11))),
        elements(beam::make_elements(model, 1.0, 0.0)),
        state(test::state_of(model)) {}

  [[nodiscard]] model::NodalLoads loads() const {
    model::NodalLoads loads(model.nodes.size());
    beam::ElementWork work(model.nodes.size());
    beam::set_internal_force(elements, state, 0.0, work, loads);
    return loads;
  }
  [[nodiscard]] double energy() const { return beam::strain_energy(elements, state); }
};

/// A crooked yarn of four elements, every node moved and turned at random.
Beam random_beam(std::mt19937& random, double move, double rotation) {
  std::vector<Eigen::Vector3d> nodes;
  nodes.reserve(5);
  for (int i = 0; i < 5; ++i) nodes.emplace_back(Eigen::Vector3d(0.8 * i, 0, 0) + random_vector(random, 0.25));
  Beam beam(nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Eigen::Vector3d shift = random_vector(random, move);
    beam.state.position.add(i, {shift.x(), shift.y(), shift.z()});
    set_rotation(beam.state, i, turn(random_vector(random, rotation)));
  }
  return beam;
}

/// Derivative of the strain energy by central differences, six values per node.
Eigen::VectorXd numerical_gradient(Beam beam) {
  const double h = 1e-6;
  const std::size_t n = beam.model.nodes.size();
  Eigen::VectorXd gradient(static_cast<Eigen::Index>(6 * n));
  const model::State start = beam.state;
  for (std::size_t node = 0; node < n; ++node) {
    for (int axis = 0; axis < 6; ++axis) {
      double difference = 0;
      for (const double side : {1.0, -1.0}) {
        const Eigen::Vector3d unit = side * h * Eigen::Vector3d::Unit(axis % 3);
        beam.state = start;
        if (axis < 3) {
          beam.state.position.add(node, {unit.x(), unit.y(), unit.z()});
        } else {
          set_rotation(beam.state, node, turn(unit) * rotation_of(start, node));
        }
        difference += side * beam.energy();
      }
      gradient[static_cast<Eigen::Index>(6 * node) + axis] = difference / (2 * h);
    }
  }
  return gradient;
}

TEST(Element, GivenRandomStatesWithLargeRotations_ThenTheLoadsAreTheNegativeDerivativeOfTheEnergy) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    // Relative rotations of the nodes reach 2.9 rad; at pi the shorter way round changes sides.
    const Beam beam = random_beam(random, 0.3, trial % 2 == 0 ? 0.8 : 0.1);
    const model::NodalLoads loads = beam.loads();
    const Eigen::VectorXd gradient = numerical_gradient(beam);
    const double scale = gradient.cwiseAbs().maxCoeff();
    for (std::size_t node = 0; node < 5; ++node) {
      const auto at = static_cast<Eigen::Index>(6 * node);
      EXPECT_LT((vector_at(loads.force, node) + gradient.segment<3>(at)).norm(), 1e-7 * scale) << "trial " << trial;
      EXPECT_LT((vector_at(loads.moment, node) + gradient.segment<3>(at + 3)).norm(), 1e-7 * scale)
          << "trial " << trial;
    }
  }
}

TEST(Element, GivenAnyState_ThenForcesAndMomentsAreInBalance) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 100; ++trial) {
    const Beam beam = random_beam(random, 0.3, 1.0);
    const model::NodalLoads loads = beam.loads();
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (std::size_t node = 0; node < 5; ++node) {
      force += vector_at(loads.force, node);
      moment +=
          vector_at(loads.moment, node) + vector_at(beam.state.position, node).cross(vector_at(loads.force, node));
    }
    EXPECT_LT(force.norm(), 1e-12);
    EXPECT_LT(moment.norm(), 1e-12);
  }
}

TEST(Element, GivenARigidMotion_ThenThereIsNoForceAndNoEnergy) {
  std::mt19937 random(13);
  for (int trial = 0; trial < 100; ++trial) {
    Beam beam = random_beam(random, 0.0, 0.0);
    const Eigen::Quaterniond rotation = turn(random_vector(random, 3.0));
    const Eigen::Vector3d shift = random_vector(random, 100.0);
    for (std::size_t node = 0; node < 5; ++node) {
      const Eigen::Vector3d moved = rotation * beam.model.nodes[node] + shift;
      beam.state.position.set(node, {moved.x(), moved.y(), moved.z()});
      // A yarn that has turned once more has -q in place of q everywhere; the elements must not care.
      const double sign = trial % 2 == 0 ? 1 : -1;
      set_rotation(beam.state, node, Eigen::Quaterniond(sign * rotation.coeffs()));
    }
    const model::NodalLoads loads = beam.loads();
    for (std::size_t node = 0; node < 5; ++node) {
      EXPECT_LT(vector_at(loads.force, node).norm(), 1e-11);
      EXPECT_LT(vector_at(loads.moment, node).norm(), 1e-11);
    }
    EXPECT_LT(beam.energy(), 1e-22);
  }
}

TEST(Element, GivenADeformedBeamThatIsMovedRigidly_ThenTheLoadsTurnWithItAndTheEnergyStays) {
  std::mt19937 random(17);
  for (int trial = 0; trial < 100; ++trial) {
    const Beam before = random_beam(random, 0.2, 0.4);
    Beam after = before;
    const Eigen::Quaterniond rotation = turn(random_vector(random, 3.0));
    for (std::size_t node = 0; node < 5; ++node) {
      const Eigen::Vector3d moved = rotation * vector_at(before.state.position, node);
      after.state.position.set(node, {moved.x(), moved.y(), moved.z()});
      set_rotation(after.state, node, rotation * rotation_of(before.state, node));
    }
    const model::NodalLoads loads_before = before.loads();
    const model::NodalLoads loads_after = after.loads();
    for (std::size_t node = 0; node < 5; ++node) {
      const Eigen::Vector3d force = vector_at(loads_before.force, node);
      const Eigen::Vector3d moment = vector_at(loads_before.moment, node);
      EXPECT_LT((vector_at(loads_after.force, node) - rotation * force).norm(), 1e-11 * (1 + force.norm()));
      EXPECT_LT((vector_at(loads_after.moment, node) - rotation * moment).norm(), 1e-11 * (1 + moment.norm()));
    }
    EXPECT_NEAR(after.energy(), before.energy(), 1e-12 * before.energy());
  }
}

TEST(Element, GivenABendThatGoesOnBeyond180Degrees_ThenTheMomentGoesOnGrowingWithTheAngle) {
  // The quaternion of a node that has turned by an angle a about z is (cos a/2, 0, 0, sin a/2), continuously. M = EI a
  // / L0; the series for the angle is exact to 1e-11 at 270 degrees and to 1e-7 at 330.
  const double length = 0.8;
  Beam beam(test::straight({0, 0, 0}, {length, 0, 0}, 1));
  for (int degrees = 0; degrees <= 330; ++degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    set_rotation(beam.state, 1, Eigen::Quaterniond(std::cos(angle / 2), 0, 0, std::sin(angle / 2)));
    // The chord stays in line with the mid frame and keeps its length, so that neither stretch nor shear adds to it.
    const Eigen::Vector3d end = length * Eigen::Vector3d(std::cos(angle / 2), std::sin(angle / 2), 0);
    beam.state.position.set(1, {end.x(), end.y(), end.z()});
    const double expected = 0.0173 * angle / length;
    const double accuracy = degrees <= 270 ? 1e-10 : 1e-6;
    const model::NodalLoads loads = beam.loads();
    EXPECT_NEAR(vector_at(loads.moment, 0).z(), expected, accuracy * (expected + 1e-3)) << degrees;
    EXPECT_NEAR(vector_at(loads.moment, 1).z(), -expected, accuracy * (expected + 1e-3)) << degrees;
    EXPECT_NEAR(beam.energy(), 0.5 * expected * angle, accuracy * (0.5 * expected * angle + 1e-3)) << degrees;
  }
}

TEST(Element, GivenTwoYarns_ThenTheLastNodeOfOneDoesNotPullOnTheFirstOfTheNext) {
  model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {2, 0, 0}, 2), test::straight({0, 5, 0}, {2, 5, 0}, 2)},
                          test::section(19.0, 6.1, 0.0173, 0.0124, 1.3e-11));
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.06);
  model::State state = test::state_of(model);
  state.position.add(3, {0, 3, 1});
  state.position.add(4, {0, 3, 1});
  state.position.add(5, {0, 3, 1});
  beam::ElementWork work(6);
  model::NodalLoads loads(6);
  beam::set_internal_force(elements, state, 0.0, work, loads);
  for (std::size_t node = 0; node < 6; ++node) EXPECT_EQ(vector_at(loads.force, node).norm(), 0.0);
}

TEST(Element, GivenAStretchingBeam_ThenBulkViscosityResistsWithB1RhoCAAndLosesThatPower) {
  const double b1 = 0.06;
  const double scaling = 100;
  Beam beam(test::straight({0, 0, 0}, {1, 0, 0}, 1));
  beam.elements = beam::make_elements(beam.model, scaling, b1);
  beam.state.velocity.x[1] = 3.0;  // mm/s
  beam::ElementWork work(2);
  model::NodalLoads loads(2);
  const double step = 1e-3;
  beam::set_internal_force(beam.elements, beam.state, 0, work, loads);
  // rho c A = sqrt(E rho) A = sqrt(EA rho A)
  const double expected = b1 * std::sqrt(19.0 * 1.3e-11 * scaling) * 3.0;
  EXPECT_NEAR(loads.force.x[1], -expected, 1e-12 * expected);
  EXPECT_NEAR(loads.force.x[0], expected, 1e-12 * expected);
  // The force has worked against the mean of the speeds before and after its step, 3 and 5 mm/s.
  EXPECT_EQ(beam::damping_loss(work), 0);
  beam.state.velocity.x[1] = 5.0;
  beam::set_internal_force(beam.elements, beam.state, step, work, loads);
  EXPECT_NEAR(beam::damping_loss(work), expected * 4.0 * step, 1e-12 * expected * step);
}

}  // namespace
}  // namespace knitmech
