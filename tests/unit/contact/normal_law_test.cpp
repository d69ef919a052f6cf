#include "contact/normal_law.h"

#include <gtest/gtest.h>

namespace knitmech::contact {
namespace {

constexpr double kRadii = 0.12;  // mm

TEST(NormalLaw, GivenAnyPenetration_ThenForceAndTangentAreDerivativesOfTheEnergy) {
  for (double penetration = 0.001; penetration < 0.11; penetration += 0.001) {
    const double h = 1e-7;
    const double slope = (normal_energy(penetration + h, kRadii) - normal_energy(penetration - h, kRadii)) / (2 * h);
    const double second = (normal_force(penetration + h, kRadii) - normal_force(penetration - h, kRadii)) / (2 * h);
    EXPECT_NEAR(normal_force(penetration, kRadii), slope, 1e-6 * slope);
    EXPECT_NEAR(normal_tangent(penetration, kRadii), second, 1e-5 * second);
  }
}

TEST(NormalLaw, GivenASmallPenetration_ThenItIsALinearPenalty) {
  EXPECT_NEAR(normal_force(1e-6, kRadii), 1e-6, 1e-10);
  EXPECT_NEAR(normal_tangent(1e-6, kRadii), 1.0, 1e-4);
}

TEST(NormalLaw, GivenCentrelinesThatNearlyMeet_ThenTheForceGrowsWithoutBound) {
  double before = 0;
  for (const double left : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const double force = normal_force(kRadii - left, kRadii);
    EXPECT_GT(force, 90 * before);
    before = force;
  }
  EXPECT_GT(before, 1e5 * kRadii);
}

}  // namespace
}  // namespace knitmech::contact
