#include "beam/rotation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace knitmech::beam {
namespace {

TEST(HalfAngle, GivenAnyAngleUpTo90Degrees_ThenTheRatioIsPhiOverSinPhi) {
  for (int i = 1; i <= 157; ++i) {
    const double phi = 0.01 * i;
    const HalfAngle half = half_angle(std::cos(phi));
    const double f = phi / std::sin(phi);
    EXPECT_NEAR(half.ratio, f, 2e-14 * f) << "phi = " << phi;
    EXPECT_NEAR(half.ratio_slope, (1 - f) / std::pow(std::sin(phi), 2), 1e-11 + 2e-15 / (phi * phi)) << "phi = " << phi;
    EXPECT_NEAR(half.cos_half, std::cos(phi / 2), 1e-15) << "phi = " << phi;
  }
}

TEST(HalfAngle, GivenNoRotation_ThenTheLimitsAreExact) {
  const HalfAngle half = half_angle(1.0);
  EXPECT_DOUBLE_EQ(half.ratio, 1.0);
  // (1 - phi / sin phi) / sin^2 phi -> -1/6
  EXPECT_NEAR(half.ratio_slope, -1.0 / 6.0, 1e-15);
}

}  // namespace
}  // namespace knitmech::beam
