#include "contact/normal_law.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace knitmech::contact {
namespace {

constexpr double kRadii = 0.12;  // mm

/// Penetrations on both sides of the switch from the series to the closed form [share of the radii].
constexpr std::array<double, 8> kShares = {1e-3, 5e-3, 0.015, 0.03, 0.1, 0.3, 0.6, 0.9};

/// Simpson's rule; the functions here are smooth, so that 2000 strips are exact to 1e-10.
template <typename Function>
double integral(double from, double to, const Function& function) {
  constexpr int kStrips = 2000;
  const double step = (to - from) / kStrips;
  double sum = function(from) + function(to);
  for (int i = 1; i < kStrips; ++i) sum += (i % 2 == 0 ? 2 : 4) * function(from + i * step);
  return sum * step / 3;
}

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

TEST(NormalLaw, GivenTheOverlapWhereTheLawsSwitch_ThenTheSeriesAreTheClosedForms) {
  // A hair above the switch, where the closed forms are taken.
  const double d = kSmallOverlap * kRadii * (1 + 1e-12);
  const auto expect_same = [](double series, double closed) { EXPECT_NEAR(series, closed, 1e-8 * closed); };
  expect_same(small_normal_energy(d, kRadii), normal_energy(d, kRadii));
  expect_same(small_integral_of_energy(d, kRadii), integral_of_energy(d, kRadii));
}

TEST(NormalLaw, GivenAnyOverlap_ThenTheEnergyIsTheNumericalIntegralOfTheForce) {
  for (const double share : kShares) {
    const double d = share * kRadii;
    const double expected = integral(0, d, [](double x) { return normal_force(x, kRadii); });
    EXPECT_NEAR(normal_energy(d, kRadii), expected, 1e-9 * expected) << share;
  }
}

TEST(NormalLaw, GivenAnyOverlap_ThenTheIntegralOfTheEnergyIsTheNumericalOne) {
  for (const double share : kShares) {
    const double d = share * kRadii;
    const double expected = integral(0, d, [](double x) { return normal_energy(x, kRadii); });
    EXPECT_NEAR(integral_of_energy(d, kRadii), expected, 1e-9 * expected) << share;
  }
}

}  // namespace
}  // namespace knitmech::contact
