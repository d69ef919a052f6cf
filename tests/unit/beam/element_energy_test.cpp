// The loads of the elements against the derivative of an energy that is written a second time, from the formulas of
// docs/theory.md with Eigen's quaternions and no function of the program.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "../../support/beam_case.h"
#include "beam/elements.h"
#include "beam/internal_force.h"

namespace knitmech {
namespace {

using Random = std::mt19937;
using Nodes = std::vector<Eigen::Vector3d>;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Eigen::Vector3d random_direction(Random& random) {
  Eigen::Vector3d vector;
  do {
    vector = Eigen::Vector3d(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1));
  } while (vector.norm() > 1 || vector.norm() < 0.1);
  return vector.normalized();
}

/// A quantity of any order of magnitude between low and high.
double of_any_size(Random& random, double low, double high) {
  return std::exp(between(random, std::log(low), std::log(high)));
}

/// Positions and rotations of the nodes of one yarn.
struct Pose {
  Nodes position;
  std::vector<Eigen::Quaterniond> rotation;
};

struct Yarn {
  Nodes rest;
  yarn::Section section;
  Pose pose;
};

constexpr double kLargestAngle = 170 * std::numbers::pi / 180;

/// Three elements of different lengths, crooked when free of stress, with stiffnesses that are orders of magnitude
/// apart, moved far: each node is turned against the one before by up to 170 degrees about any axis.
Yarn random_yarn(Random& random) {
  Yarn yarn;
  Eigen::Vector3d end = 10 * random_direction(random);
  Eigen::Vector3d course = random_direction(random);
  Eigen::Quaterniond rotation = test::turn(between(random, 0, 3) * random_direction(random));
  const double stretch = of_any_size(random, 1e-4, 0.3);
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  for (int i = 0; i < 4; ++i) {
    yarn.rest.push_back(end);
    yarn.pose.position.push_back(moved);
    yarn.pose.rotation.push_back(rotation);
    const Eigen::Vector3d chord = of_any_size(random, 0.4, 2) * course;
    const Eigen::Quaterniond turned =
        rotation * test::turn(between(random, 0, kLargestAngle) * random_direction(random));
    const Eigen::Quaterniond middle = rotation.slerp(0.5, turned);
    end += chord;
    moved += middle * (chord + stretch * chord.norm() * random_direction(random));
    course = (course + random_direction(random)).normalized();
    rotation = turned;
  }
  const double bending = of_any_size(random, 1e-3, 10);
  yarn.section = test::section(of_any_size(random, 0.1, 1e3), of_any_size(random, 0.1, 1e3), bending,
                               bending * of_any_size(random, 0.01, 100), 1e-11);
  return yarn;
}

/// W = L0/2 (EA epsilon^2 + k G A' gamma . gamma) + 1/(2 L0) (EI theta . theta + (GJ - EI) (e1 . theta)^2)
double energy_of_element(const Yarn& yarn, const Pose& pose, std::size_t i) {
  const Eigen::Vector3d rest = yarn.rest[i + 1] - yarn.rest[i];
  const double length = rest.norm();
  const Eigen::Vector3d e1 = rest / length;
  const Eigen::AngleAxisd relative(pose.rotation[i].conjugate() * pose.rotation[i + 1]);
  const Eigen::Vector3d theta = relative.angle() * relative.axis();
  const Eigen::Quaterniond mean =
      pose.rotation[i] * Eigen::Quaterniond(Eigen::AngleAxisd(relative.angle() / 2, relative.axis()));
  const Eigen::Vector3d rho = mean.conjugate() * (pose.position[i + 1] - pose.position[i]);
  const double epsilon = rho.norm() / length - 1;
  const Eigen::Vector3d gamma = (rho - e1.dot(rho) * e1) / length;
  const yarn::Section& s = yarn.section;
  const double shear =
      s.shear_stiffness / (1 + 0.25 * length * length * s.axial_stiffness / (12 * s.bending_stiffness));
  const double twist = e1.dot(theta);
  return length / 2 * (s.axial_stiffness * epsilon * epsilon + shear * gamma.squaredNorm()) +
         1 / (2 * length) *
             (s.bending_stiffness * theta.squaredNorm() +
              (s.torsional_stiffness - s.bending_stiffness) * twist * twist);
}

double plain_energy(const Yarn& yarn, const Pose& pose) {
  double energy = 0;
  for (std::size_t i = 0; i + 1 < yarn.rest.size(); ++i) energy += energy_of_element(yarn, pose, i);
  return energy;
}

/// Central difference of fourth order of the energy, for a small motion along (axis 0 to 2) or rotation about (3 to 5)
/// the axes of space.
double derivative(const Yarn& yarn, std::size_t node, int axis) {
  const double h = 1e-4;  // [mm] or [rad]
  const auto energy_at = [&](double by) {
    Pose pose = yarn.pose;
    const Eigen::Vector3d motion = by * Eigen::Vector3d::Unit(axis % 3);
    if (axis < 3) {
      pose.position[node] += motion;
    } else {
      pose.rotation[node] = test::turn(motion) * pose.rotation[node];
    }
    return plain_energy(yarn, pose);
  };
  return (8 * (energy_at(h) - energy_at(-h)) - (energy_at(2 * h) - energy_at(-2 * h))) / (12 * h);
}

/// The same yarn in the program.
struct Program {
  model::Model model;
  beam::Elements elements;
  model::State state;

  explicit Program(const Yarn& yarn)
      : model(test::yarns_through({yarn.rest}, yarn.section)),
        elements(beam::make_elements(model, 1.0, 0.0)),
        state(yarn.rest.size()) {
    for (std::size_t i = 0; i < yarn.rest.size(); ++i) {
      const Eigen::Vector3d& x = yarn.pose.position[i];
      state.position.set(i, {x.x(), x.y(), x.z()});
      test::set_rotation(state, i, yarn.pose.rotation[i]);
    }
  }
  [[nodiscard]] model::NodalLoads loads() const {
    model::NodalLoads loads(model.nodes.size());
    beam::ElementWork work(model.nodes.size());
    beam::set_internal_force(elements, state, 0.0, work, loads);
    return loads;
  }
};

TEST(ElementEnergy, GivenThousandsOfElementsTurnedByUpTo170Degrees_ThenTheEnergyIsThatOfTheTheory) {
  Random random(23);
  for (int trial = 0; trial < 2000; ++trial) {
    const Yarn yarn = random_yarn(random);
    const Program program(yarn);
    const double expected = plain_energy(yarn, yarn.pose);
    EXPECT_NEAR(beam::strain_energy(program.elements, program.state), expected, 1e-12 * expected) << "trial " << trial;
  }
}

TEST(ElementEnergy, GivenThousandsOfElementsTurnedByUpTo170Degrees_ThenTheLoadsAreItsNegativeDerivative) {
  // Bound on the error over energy and largest load: the truncation of the differences falls with the fourth power of
  // their step, and 1e-3 to 1e-4 showed that it does; at 1e-4 it is as small as rounding, and both leave 1.6e-11.
  Random random(29);
  double largest_error = 0;
  double largest_angle = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const Yarn yarn = random_yarn(random);
    const model::NodalLoads loads = Program(yarn).loads();
    Eigen::Matrix<double, 6, 4> gradient;
    Eigen::Matrix<double, 6, 4> computed;
    for (std::size_t node = 0; node < 4; ++node) {
      const auto column = static_cast<Eigen::Index>(node);
      for (int axis = 0; axis < 6; ++axis) gradient(axis, column) = derivative(yarn, node, axis);
      computed.col(column) << test::vector_at(loads.force, node), test::vector_at(loads.moment, node);
      if (node > 0) {
        const double angle = yarn.pose.rotation[node - 1].angularDistance(yarn.pose.rotation[node]);
        largest_angle = std::max(largest_angle, angle);
      }
    }
    const double scale = plain_energy(yarn, yarn.pose) + gradient.cwiseAbs().maxCoeff();
    largest_error = std::max(largest_error, (computed + gradient).cwiseAbs().maxCoeff() / scale);
  }
  EXPECT_LT(largest_error, 1e-10);
  EXPECT_GT(largest_angle, 0.99 * kLargestAngle);
}

}  // namespace
}  // namespace knitmech
