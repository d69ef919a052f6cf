#include "beam/fold_limit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "../../support/beam_case.h"

namespace knitmech {
namespace {

using Eigen::Vector3d;
using test::vector_at;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kAxial = 19.0;
constexpr double kLength = 0.8;  // mm, of each of the three elements

/// A yarn of loose filaments, far softer than a solid one of its diameter (EA D^2 / 16 = 0.0171 N mm^2).
model::Model yarn_with_bending(double bending) {
  return test::yarns_through({test::straight({0, 0, 0}, {3 * kLength, 0, 0}, 3)},
                             test::section(kAxial, 6, bending, 0.7 * bending, 1.3e-11, 0.12));
}

struct Yarn {
  model::Model model;
  beam::FoldLimit limit;
  model::State state;

  explicit Yarn(double bending = 5e-6)
      : model(yarn_with_bending(bending)), limit(beam::make_elements(model, 1.0, 0.0)), state(test::state_of(model)) {}

  model::NodalLoads loads() {
    model::NodalLoads loads(model.nodes.size());
    limit.add_moments(state, loads);
    return loads;
  }
  double energy() {
    (void)loads();
    return limit.energy();
  }
  /// Folds the middle element by an angle about an axis, after all was turned by `before`.
  void fold(double angle, const Vector3d& axis, const Eigen::Quaterniond& before = Eigen::Quaterniond::Identity()) {
    for (std::size_t i = 0; i < 4; ++i) {
      // Not by AngleAxis and back: beyond 180 degrees the quaternion has to go on.
      const double half = 0.5 * (i < 2 ? 0 : angle);
      Eigen::Quaterniond turned;
      turned.w() = std::cos(half);
      turned.vec() = std::sin(half) * axis;
      test::set_rotation(state, i, before * turned);
    }
  }
};

Vector3d random_axis(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

TEST(FoldLimit, GivenAFoldUpTo149Degrees_ThenNothingResists) {
  Yarn yarn;
  for (int degrees = 0; degrees <= 149; ++degrees) {
    yarn.fold(degrees * kDegree, Vector3d::UnitZ());
    const model::NodalLoads loads = yarn.loads();
    EXPECT_EQ(yarn.limit.energy(), 0) << degrees;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(vector_at(loads.moment, i).norm(), 0) << degrees;
  }
}

TEST(FoldLimit, GivenAFoldBeyond150Degrees_ThenItIsResistedInProportionToWhatIsBeyond) {
  // k = EA L0 / 8, W = k / 2 (theta - 2.618)^2, also beyond 180 degrees.
  Yarn yarn;
  const double k = kAxial * kLength / 8;
  for (const double degrees : {151.0, 170.0, 180.0, 200.0, 300.0}) {
    const double beyond = degrees * kDegree - 2.618;
    yarn.fold(degrees * kDegree, Vector3d::UnitZ());
    const model::NodalLoads loads = yarn.loads();
    EXPECT_NEAR(yarn.limit.energy(), 0.5 * k * beyond * beyond, 1e-13) << degrees;
    EXPECT_LT((vector_at(loads.moment, 1) - k * beyond * Vector3d::UnitZ()).norm(), 1e-13) << degrees;
    EXPECT_LT((vector_at(loads.moment, 2) + k * beyond * Vector3d::UnitZ()).norm(), 1e-13) << degrees;
    for (const std::size_t far : {0U, 3U}) EXPECT_EQ(vector_at(loads.moment, far).norm(), 0);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(vector_at(loads.force, i).norm(), 0);
  }
}

TEST(FoldLimit, GivenAFoldAboutAnyAxis_ThenTheMomentsAreTheNegativeDerivativeOfTheEnergy) {
  std::mt19937 random(3);
  const double h = 1e-6;  // rad
  for (int trial = 0; trial < 200; ++trial) {
    Yarn yarn;
    yarn.fold((155 + trial % 150) * kDegree, random_axis(random), test::turn(2 * random_axis(random)));
    const model::State start = yarn.state;
    const model::NodalLoads loads = yarn.loads();
    for (std::size_t node = 0; node < 4; ++node) {
      for (int axis = 0; axis < 3; ++axis) {
        double difference = 0;
        for (const double side : {1.0, -1.0}) {
          yarn.state = start;
          test::set_rotation(yarn.state, node,
                             test::turn(side * h * Vector3d::Unit(axis)) * test::rotation_of(start, node));
          difference += side * yarn.energy();
        }
        ASSERT_NEAR(vector_at(loads.moment, node)[axis], -difference / (2 * h), 1e-8) << "trial " << trial;
      }
    }
  }
}

TEST(FoldLimit, GivenAFoldedYarnThatTurnsAsAWhole_ThenTheMomentsTurnWithItAndTheEnergyStays) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    Yarn yarn;
    const Vector3d axis = random_axis(random);
    yarn.fold(190 * kDegree, axis);
    const model::NodalLoads before = yarn.loads();
    const double energy = yarn.limit.energy();
    const Eigen::Quaterniond rotation = test::turn(3 * random_axis(random));
    yarn.fold(190 * kDegree, axis, rotation);
    const model::NodalLoads after = yarn.loads();
    EXPECT_NEAR(yarn.limit.energy(), energy, 1e-13);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT((vector_at(after.moment, i) - rotation * vector_at(before.moment, i)).norm(), 1e-13);
    }
  }
}

TEST(FoldLimit, GivenAMonofilament_ThenItHasNone) {
  Yarn yarn(kAxial * 0.12 * 0.12 / 16);  // EI of a solid circle
  yarn.fold(200 * kDegree, Vector3d::UnitZ());
  EXPECT_EQ(yarn.energy(), 0);
}

}  // namespace
}  // namespace knitmech
