#include "yarn/axial_law.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "base/errors.h"

namespace knitmech::yarn {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Points of a polymer-like curve, steep at first and then ever flatter: N = 2 (1 - exp(-e / 0.05)) + 6 e.
double smooth_force(double strain) {
  return 2 * (1 - std::exp(-strain / 0.05)) + 6 * strain;
}
double smooth_slope(double strain) {
  return 40 * std::exp(-strain / 0.05) + 6;
}
double smooth_energy(double strain) {
  return 2 * strain - 0.1 * (1 - std::exp(-strain / 0.05)) + 3 * strain * strain;
}

std::vector<AxialPoint> smooth_points(int n_intervals) {
  std::vector<AxialPoint> points;
  for (int i = 0; i <= n_intervals; ++i) {
    const double strain = 0.3 * i / n_intervals;
    points.push_back({strain, smooth_force(strain)});
  }
  return points;
}

TEST(AxialLaw, OfTwoPointsIsHookesLaw) {
  // Given EA = 20 N, when strained either way and beyond the last point, then N = EA e and the energy is EA e^2 / 2.
  const AxialLaw law({{0, 0}, {0.1, 2}});
  for (const double strain : {-0.2, -1e-9, 0.0, 0.03, 0.1, 0.5}) {
    EXPECT_NEAR(law.force(strain), 20 * strain, 1e-14);
    EXPECT_NEAR(law.slope(strain), 20, 1e-13);
    EXPECT_NEAR(law.energy(strain), 10 * strain * strain, 1e-14);
  }
  EXPECT_NEAR(law.slope_at_zero(), 20, 1e-13);
  EXPECT_NEAR(law.largest_slope(), 20, 1e-13);
  EXPECT_EQ(law.last_strain(), 0.1);
}

TEST(AxialLaw, SaysAtWhichStrainAForceIsReached) {
  const AxialLaw law(smooth_points(7));
  for (const double strain : {1e-6, 0.01, 0.1, 0.27, 0.5}) {
    EXPECT_NEAR(law.strain_at(law.force(strain)), strain, 1e-12) << strain;
  }
  // A curve that ends flat: at its force the least strain that has it, above it none.
  const AxialLaw flat({{0, 0}, {0.1, 2}, {0.2, 2}, {0.3, 2}});
  EXPECT_NEAR(flat.strain_at(2), 0.1, 1e-7);
  EXPECT_EQ(flat.strain_at(2.001), std::numeric_limits<double>::infinity());
}

TEST(AxialLaw, GoesThroughItsPoints) {
  const auto points = smooth_points(7);
  const AxialLaw law(points);
  for (const AxialPoint& point : points) EXPECT_NEAR(law.force(point.strain), point.force, 1e-14);
}

TEST(AxialLaw, FollowsASmoothCurveBetweenItsPoints) {
  // Reference: the curve from which the points are, its derivative and its integral, here by hand. Twice the points, an
  // error of the force at least four times smaller (the harmonic mean of secants is of second order at least).
  const auto largest_error = [](int n_intervals) {
    const AxialLaw law(smooth_points(n_intervals));
    double error = 0;
    for (double strain = 0; strain <= 0.3; strain += 1e-4) {
      error = std::max(error, std::abs(law.force(strain) - smooth_force(strain)));
    }
    return error;
  };
  EXPECT_LT(largest_error(32), 2e-3);  // of 3.8 N
  EXPECT_LT(largest_error(64), largest_error(32) / 4);
  const AxialLaw law(smooth_points(32));
  EXPECT_NEAR(law.slope_at_zero(), smooth_slope(0), 0.02 * smooth_slope(0));
  EXPECT_NEAR(law.slope(0.2), smooth_slope(0.2), 0.01 * smooth_slope(0.2));
  EXPECT_NEAR(law.energy(0.3), smooth_energy(0.3), 1e-3 * smooth_energy(0.3));
}

TEST(AxialLaw, HasTheSlopeAndTheEnergyOfItsForce) {
  // Reference: the force itself, differentiated and integrated numerically, also outside the points.
  const AxialLaw law(smooth_points(9));
  constexpr double kStep = 1e-6;
  double integral = 0;
  for (double strain = -0.05; strain < 0.4; strain += 1e-3) {
    const double middle = strain + 0.5e-3;
    EXPECT_NEAR(law.slope(middle), (law.force(middle + kStep) - law.force(middle - kStep)) / (2 * kStep), 2e-5);
    // Simpson's rule, exact for a cubic; a cell that spans two pieces errs by far less than the tolerance.
    integral += (law.force(strain) + 4 * law.force(middle) + law.force(strain + 1e-3)) / 6 * 1e-3;
    EXPECT_NEAR(law.energy(strain + 1e-3) - law.energy(-0.05), integral, 1e-7);
  }
}

TEST(AxialLaw, IsStraightBelowZeroAndBeyondTheLastPoint) {
  const AxialLaw law(smooth_points(9));
  EXPECT_NEAR(law.force(-0.1), -0.1 * law.slope_at_zero(), 1e-14);
  EXPECT_EQ(law.slope(-0.1), law.slope_at_zero());
  const double last = law.last_strain();
  EXPECT_NEAR(law.force(last + 0.2), law.force(last) + 0.2 * law.slope(last), 1e-13);
  EXPECT_EQ(law.slope(last + 0.2), law.slope(last));
}

TEST(AxialLaw, NeverFallsHoweverUnevenItsPoints) {
  // Given random rising points with plateaus and jumps of a thousand times, when the law is sampled finely, then the
  // force never falls (a natural spline through the same points does), and no slope is above the largest.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int curve = 0; curve < 200; ++curve) {
    std::vector<AxialPoint> points = {{0, 0}};
    for (int i = 0; i < 12; ++i) {
      const bool flat = i > 0 && uniform(random) < 0.2;
      const double rise = flat ? 0 : std::pow(10, -3 * uniform(random));
      points.push_back({points.back().strain + 1e-3 + 0.02 * uniform(random), points.back().force + rise});
    }
    const AxialLaw law(points);
    ASSERT_GT(law.slope_at_zero(), 0);
    double before = law.force(-0.01);
    for (double strain = -0.01; strain < law.last_strain() + 0.01; strain += 2e-5) {
      const AxialResponse response = law.at(strain);
      ASSERT_GE(response.force, before - 1e-12);
      ASSERT_GE(response.slope, -1e-9);
      ASSERT_LE(response.slope, law.largest_slope() * (1 + 1e-12));
      before = response.force;
    }
  }
}

TEST(AxialLaw, KeepsAThirdOfTheFirstSecantAsSlopeAtZero) {
  // Given a slack start, secants 10 N and then 100 N, whose parabola would begin with a negative slope.
  EXPECT_NEAR(AxialLaw({{0, 0}, {0.01, 0.1}, {0.02, 1.1}}).slope_at_zero(), 10.0 / 3, 1e-12);
}

TEST(AxialLaw, FindsTheLargestSlopeWithinAPiece) {
  // Given a step between two nearly flat stretches, the steepest place is in the middle of the step: 3/2 of its secant
  // for a cubic with end slopes near 0.
  const AxialLaw law({{0, 0}, {0.1, 0.001}, {0.2, 1.001}, {0.3, 1.002}});
  EXPECT_NEAR(law.largest_slope(), 15, 0.1);
  EXPECT_NEAR(law.slope(0.15), law.largest_slope(), 1e-6);
}

struct WrongPoints {
  std::vector<AxialPoint> points;
  std::string complaint;
};
class WrongAxialLaw : public testing::TestWithParam<WrongPoints> {};
INSTANTIATE_TEST_SUITE_P(
    Points, WrongAxialLaw,
    testing::Values(
        WrongPoints{{}, "0 points"}, WrongPoints{{{0, 0}}, "1 points"}, WrongPoints{{{0, 0.1}, {0.1, 2}}, "point 1 "},
        WrongPoints{{{0.1, 0}, {0.2, 2}}, "point 1 "}, WrongPoints{{{0, 0}, {0.1, 0}}, "point 2 "},
        WrongPoints{{{0, 0}, {0, 2}}, "point 2 "}, WrongPoints{{{0, 0}, {1e-300, 2}}, "point 2 "},
        WrongPoints{{{0, 0}, {0.1, 2}, {0.09, 3}}, "point 3 of the axial law has the strain 0.09 after 0.1"},
        WrongPoints{{{0, 0}, {0.1, 2}, {0.2, 1.9}}, "point 3 of the axial law has the force 1.9 N after 2 N"},
        WrongPoints{{{0, 0}, {0.1, std::numeric_limits<double>::quiet_NaN()}}, "point 2 "},
        WrongPoints{{{0, 0}, {std::numeric_limits<double>::infinity(), 1}}, "point 2 "}));

TEST_P(WrongAxialLaw, IsRefusedWithItsPoint) {
  EXPECT_THAT([] { (void)AxialLaw(GetParam().points); }, ThrowsMessage<InputError>(HasSubstr(GetParam().complaint)));
}

}  // namespace
}  // namespace knitmech::yarn
