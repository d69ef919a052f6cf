#include "solve/integrate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../../support/beam_case.h"

namespace knitmech {
namespace {

constexpr double kMass = 2.0;
constexpr double kRotary = 0.5;

struct Node {
  beam::NodalInertia inertia{{kMass}, {kRotary}, 0};
  model::State state{1};
  model::NodalLoads loads{1};
};

TEST(Integrate, GivenAConstantForce_ThenVelocityAndPositionAreThoseOfTheLeapfrog) {
  Node node;
  node.loads.force.set(0, {4, 0, -2});
  solve::integrate(node.inertia, node.loads, {0.1, 0.3}, 0.0, node.state);
  EXPECT_NEAR(node.state.velocity.x[0], 4 / kMass * 0.2, 1e-15);  // over the mean of both steps
  EXPECT_NEAR(node.state.position.x[0], 4 / kMass * 0.2 * 0.3, 1e-15);
  EXPECT_NEAR(node.state.velocity.z[0], -2 / kMass * 0.2, 1e-15);
  EXPECT_DOUBLE_EQ(node.state.time, 0.3);
}

TEST(Integrate, GivenASpring_ThenTheFrequencyIsThatOfTheLeapfrog) {
  // x'' = -k x / m by central differences: sin(w h / 2) = h / 2 sqrt(k / m) for the observed w.
  const double stiffness = 8.0;
  const double step = 0.2;
  Node node;
  node.state.position.x[0] = 1;
  double crossing = 0;
  double before = 1;
  for (int i = 0; crossing == 0; ++i) {
    node.loads.force.x[0] = -stiffness * node.state.position.x[0];
    // From rest at x = 1, the first velocity is only half a step away.
    if (i == 0) node.loads.force.x[0] *= 0.5;
    solve::integrate(node.inertia, node.loads, {step, step}, 0.0, node.state);
    const double x = node.state.position.x[0];
    if (x <= 0) crossing = node.state.time - step + step * before / (before - x);
    before = x;
  }
  const double observed = 2 / step * std::asin(0.5 * step * std::sqrt(stiffness / kMass));
  EXPECT_NEAR(crossing, std::acos(-1.0) / 2 / observed, 0.002);
}

TEST(Integrate, GivenMassDamping_ThenTheVelocityDecaysWithIt) {
  Node node;
  node.state.velocity.x[0] = 1;
  const double step = 1e-3;
  for (int i = 0; i < 1000; ++i) solve::integrate(node.inertia, node.loads, {step, step}, 2.0, node.state);
  EXPECT_NEAR(node.state.velocity.x[0], std::exp(-2.0), 1e-6);
}

TEST(Integrate, GivenASteadyAngularVelocity_ThenTheRotationIsExactAndStaysAUnitQuaternion) {
  Node node;
  const Eigen::Vector3d velocity(3, -2, 5);
  node.state.angular_velocity.set(0, {velocity.x(), velocity.y(), velocity.z()});
  const double step = 1e-3;
  for (int i = 0; i < 5000; ++i) solve::integrate(node.inertia, node.loads, {step, step}, 0.0, node.state);
  const Eigen::Quaterniond expected = test::turn(velocity * 5.0);
  const Eigen::Quaterniond found = test::rotation_of(node.state, 0);
  EXPECT_NEAR(found.norm(), 1.0, 1e-14);
  EXPECT_NEAR(std::abs(found.dot(expected)), 1.0, 1e-13);
}

TEST(MassDampingLoss, GivenANodeThatIsDampedAndPulled_ThenItIsWhatForceAndMotionLeaveOut) {
  // Reference: the work of the force over the mean velocity, less the gain of kinetic energy.
  Node node;
  node.state.velocity.set(0, {3, -1, 2});
  node.state.angular_velocity.set(0, {0.5, 4, -2});
  node.loads.force.set(0, {4, 0, -2});
  node.loads.moment.set(0, {-1, 0.3, 0});
  const auto energy = [&] { return solve::kinetic_energy(node.inertia, model::NodalLoads(1), {}, node.state); };
  const model::State before = node.state;
  const double energy_before = energy();
  const solve::StepLengths step{0.1, 0.3};
  const double loss = solve::mass_damping_loss(node.inertia, node.loads, step, 2.0, node.state);
  solve::integrate(node.inertia, node.loads, step, 2.0, node.state);
  const Vector3 v = 0.5 * (before.velocity.at(0) + node.state.velocity.at(0));
  const Vector3 w = 0.5 * (before.angular_velocity.at(0) + node.state.angular_velocity.at(0));
  const double work = step.mean() * (dot(node.loads.force.at(0), v) + dot(node.loads.moment.at(0), w));
  EXPECT_GT(loss, 0);
  EXPECT_NEAR(loss, work - (energy() - energy_before), 1e-14 * energy_before);
}

TEST(KineticEnergy, GivenAVelocityAndAForce_ThenItIsThatOfTheInstantBetweenTheTwoVelocities) {
  Node node;
  node.state.velocity.x[0] = 3;
  node.loads.force.x[0] = 4;
  node.state.angular_velocity.z[0] = 2;
  const double v = 3 + 0.05 * 4 / kMass;
  EXPECT_NEAR(solve::kinetic_energy(node.inertia, node.loads, {0.1, 0.1}, node.state),
              0.5 * kMass * v * v + 0.5 * kRotary * 4, 1e-14);
}

TEST(LargestSpeed, GivenAVelocityThatIsNotANumber_ThenItSaysSo) {
  Node node;
  EXPECT_EQ(solve::largest_speed_squared(node.state), 0.0);
  node.state.velocity.y[0] = std::nan("");
  EXPECT_TRUE(std::isnan(solve::largest_speed_squared(node.state)));
  node.state.velocity.y[0] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(solve::largest_speed_squared(node.state)));
}

}  // namespace
}  // namespace knitmech
