#include "contact/friction.h"

#include <gtest/gtest.h>

namespace knitmech::contact {
namespace {

constexpr double kStiffness = 16.0;               // N/mm, of the stick
constexpr double kLimit = 0.01;                   // N, mu N
constexpr double kStretch = kLimit / kStiffness;  // mm, elastic slip when sliding starts
constexpr Vector3 kUp{0, 0, 1};

TEST(Friction, GivenASmallMotion_ThenItSticksAndNothingIsLost) {
  SlipMemory memory;
  const FrictionStep step = friction_step(memory, kUp, {0.5 * kStretch, 0, 0}, kLimit, kStiffness);
  EXPECT_FALSE(memory.slips);
  EXPECT_EQ(memory.slid, 0.0);
  EXPECT_EQ(step.loss, 0.0);
  EXPECT_NEAR(step.force.x, -0.5 * kLimit, 1e-15);
}

TEST(Friction, GivenAMotionBeyondTheCoulombLimit_ThenTheForceIsMuNAgainstTheMotionAndTheRestIsDissipated) {
  SlipMemory memory;
  const FrictionStep step = friction_step(memory, kUp, {3 * kStretch, 4 * kStretch, 0}, kLimit, kStiffness);
  EXPECT_TRUE(memory.slips);
  EXPECT_NEAR(length(step.force), kLimit, 1e-15);
  EXPECT_NEAR(step.force.x, -0.6 * kLimit, 1e-15);
  EXPECT_NEAR(step.force.y, -0.8 * kLimit, 1e-15);
  EXPECT_NEAR(step.loss, kLimit * 4 * kStretch, 1e-15);  // five stretches of motion, one of them elastic
  EXPECT_NEAR(memory.slid, 4 * kStretch, 1e-15);
}

TEST(Friction, GivenMotionAlongTheNormal_ThenThereIsNoFriction) {
  SlipMemory memory;
  EXPECT_EQ(length(friction_step(memory, {0, 1, 0}, {0, 0.01, 0}, kLimit, kStiffness).force), 0.0);
}

TEST(Friction, GivenMotionThereAndBack_ThenTheForceFollowsAHysteresisLoop) {
  SlipMemory memory;
  FrictionStep step = friction_step(memory, kUp, {2 * kStretch, 0, 0}, kLimit, kStiffness);
  EXPECT_NEAR(step.force.x, -kLimit, 1e-15);
  step = friction_step(memory, kUp, {-1 * kStretch, 0, 0}, kLimit, kStiffness);  // unloads elastically to zero
  EXPECT_NEAR(step.force.x, 0.0, 1e-15);
  EXPECT_FALSE(memory.slips);
  step = friction_step(memory, kUp, {-3 * kStretch, 0, 0}, kLimit, kStiffness);  // slides the other way
  EXPECT_NEAR(step.force.x, kLimit, 1e-15);
  EXPECT_NEAR(step.loss, kLimit * 2 * kStretch, 1e-15);
}

TEST(Friction, GivenANormalForceThatFalls_ThenTheStickIsCutDownAndItsEnergyIsLost) {
  SlipMemory memory;
  friction_step(memory, kUp, {kStretch, 0, 0}, kLimit, kStiffness);
  const FrictionStep step = friction_step(memory, kUp, {0, 0, 0}, 0.25 * kLimit, kStiffness);
  EXPECT_NEAR(step.force.x, -0.25 * kLimit, 1e-15);
  EXPECT_NEAR(step.loss, 0.5 * kStiffness * kStretch * kStretch * (1 - 0.25 * 0.25), 1e-18);
}

TEST(Friction, GivenAnyPathOfMotionAndPressure_ThenWorkDoneIsStoredOrLost) {
  // In many small steps, the work of the friction force is the change of the stick's energy plus the loss.
  SlipMemory memory;
  double work = 0;
  double loss = 0;
  Vector3 force{};
  constexpr int kSteps = 200000;
  for (int i = 0; i < kSteps; ++i) {
    const double phase = 12.0 * i / kSteps;
    const Vector3 motion = (60 * kStretch / kSteps) * Vector3{std::cos(phase), std::sin(1.7 * phase), 0};
    const double limit = kLimit * (1.2 + std::sin(2.3 * phase));
    const FrictionStep step = friction_step(memory, kUp, motion, limit, kStiffness);
    work -= 0.5 * dot(force + step.force, motion);
    loss += step.loss;
    force = step.force;
  }
  const double stored = 0.5 * kStiffness * dot(memory.elastic_slip, memory.elastic_slip);
  EXPECT_GT(loss, 10 * stored);
  EXPECT_NEAR(work, stored + loss, 1e-3 * work);
}

TEST(Friction, GivenAContactThatTurns_ThenItsStickTurnsWithIt) {
  SlipMemory memory;
  friction_step(memory, kUp, {0.5 * kStretch, 0, 0}, kLimit, kStiffness);
  // Turned by 30 degrees about y: the stick along x must now lie along (cos 30, 0, -sin 30), with its length.
  const Vector3 normal{0.5, 0, std::sqrt(0.75)};
  const FrictionStep step = friction_step(memory, normal, {0, 0, 0}, kLimit, kStiffness);
  EXPECT_NEAR(length(step.force), 0.5 * kLimit, 1e-15);
  EXPECT_NEAR(dot(step.force, normal), 0.0, 1e-17);
  EXPECT_NEAR(step.force.z / step.force.x, -0.5 / std::sqrt(0.75), 1e-12);
}

}  // namespace
}  // namespace knitmech::contact
