#include "contact/friction.h"

#include <gtest/gtest.h>

#include "contact/constants.h"

namespace knitmech::contact {
namespace {

constexpr double kStiffness = 16.0;  // N/mm
constexpr double kLimit = 0.01;      // N, mu N

ContactPoint point_with_normal(Vector3 normal, std::int32_t first = 4, std::int32_t second = 90) {
  return {contact_key(first, second), first, second, 0.5, 0.5, normal, 0.001, 0.01, kStiffness, 1e-5};
}

double stick_limit() {
  return kLimit / (kStickStiffness * kStiffness);
}  // mm, elastic slip when sliding starts

TEST(Friction, GivenASmallMotion_ThenItSticksAndNothingIsLost) {
  const FrictionStep step = friction_step(point_with_normal({0, 0, 1}), nullptr, {0.5 * stick_limit(), 0, 0}, kLimit);
  EXPECT_FALSE(step.slips);
  EXPECT_EQ(step.loss, 0.0);
  EXPECT_NEAR(step.force.x, -0.5 * kLimit, 1e-15);
}

TEST(Friction, GivenAMotionBeyondTheCoulombLimit_ThenTheForceIsMuNAgainstTheMotionAndTheRestIsDissipated) {
  const Vector3 motion{3 * stick_limit(), 4 * stick_limit(), 0};
  const FrictionStep step = friction_step(point_with_normal({0, 0, 1}), nullptr, motion, kLimit);
  EXPECT_TRUE(step.slips);
  EXPECT_NEAR(length(step.force), kLimit, 1e-15);
  EXPECT_NEAR(step.force.x, -0.6 * kLimit, 1e-15);
  EXPECT_NEAR(step.force.y, -0.8 * kLimit, 1e-15);
  EXPECT_NEAR(step.loss, kLimit * 4 * stick_limit(), 1e-15);  // 5 limits of motion, one of them elastic
}

TEST(Friction, GivenMotionAlongTheNormal_ThenThereIsNoFriction) {
  const FrictionStep step = friction_step(point_with_normal({0, 1, 0}), nullptr, {0, 0.01, 0}, kLimit);
  EXPECT_EQ(length(step.force), 0.0);
}

TEST(Friction, GivenMotionThereAndBack_ThenTheForceFollowsAHysteresisLoop) {
  const ContactPoint point = point_with_normal({0, 0, 1});
  FrictionStep step = friction_step(point, nullptr, {2 * stick_limit(), 0, 0}, kLimit);
  EXPECT_NEAR(step.force.x, -kLimit, 1e-15);
  step = friction_step(point, &step.memory, {-1 * stick_limit(), 0, 0}, kLimit);  // unloads elastically to zero
  EXPECT_NEAR(step.force.x, 0.0, 1e-15);
  EXPECT_FALSE(step.slips);
  step = friction_step(point, &step.memory, {-3 * stick_limit(), 0, 0}, kLimit);  // slides the other way
  EXPECT_NEAR(step.force.x, kLimit, 1e-15);
  EXPECT_NEAR(step.loss, kLimit * 2 * stick_limit(), 1e-15);
}

TEST(Friction, GivenAContactThatTurns_ThenItsStickTurnsWithIt) {
  FrictionStep step = friction_step(point_with_normal({0, 0, 1}), nullptr, {0.5 * stick_limit(), 0, 0}, kLimit);
  // Turned by 30 degrees about y: the stick along x must now lie along (cos 30, 0, -sin 30), with its length.
  const Vector3 normal{0.5, 0, std::sqrt(0.75)};
  step = friction_step(point_with_normal(normal), &step.memory, {0, 0, 0}, kLimit);
  EXPECT_NEAR(length(step.force), 0.5 * kLimit, 1e-15);
  EXPECT_NEAR(dot(step.force, normal), 0.0, 1e-17);
  EXPECT_NEAR(step.force.z / step.force.x, -0.5 / std::sqrt(0.75), 1e-12);
}

TEST(Friction, GivenAContactThatSlidOnToTheNextElement_ThenItsMemoryIsFound) {
  const std::vector<SlipMemory> memories = {{contact_key(4, 90), {0, 0, 1}, {1, 0, 0}, kStiffness},
                                            {contact_key(4, 92), {0, 0, -1}, {2, 0, 0}, kStiffness}};
  const ContactPoint moved = point_with_normal({0, 0, 1}, 4, 91);
  EXPECT_EQ(recall(memories, moved), nullptr);
  const SlipMemory* found = recall_moved(memories, {moved}, moved);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->key, contact_key(4, 90));  // (4, 92) presses the other way: another contact
}

TEST(Friction, GivenAnOverlapThatIsCountedOtherwiseThanBefore_ThenTheMemoryOfThePairIsFound) {
  const std::vector<SlipMemory> memories = {{contact_key(4, 90, kFirstSample + 7), {0, 0, 1}, {1, 0, 0}, kStiffness}};
  const ContactPoint whole = point_with_normal({0, 0, 1}, 4, 90);
  const SlipMemory* found = recall_moved(memories, {whole}, whole);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->key, contact_key(4, 90, kFirstSample + 7));
  const ContactPoint elsewhere = point_with_normal({0, 0, 1}, 4, 95);
  EXPECT_EQ(recall_moved(memories, {elsewhere}, elsewhere), nullptr);
}

}  // namespace
}  // namespace knitmech::contact
