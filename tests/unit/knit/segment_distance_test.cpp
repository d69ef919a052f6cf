#include "knit/segment_distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace knitmech::knit {
namespace {

using Eigen::Vector3d;

TEST(SegmentDistance, OfCrossingSegmentsIsAlongTheirCommonNormal) {
  const auto at = closest_approach({-1, 0, 0}, {1, 0, 0}, {0.5, -1, 0.3}, {0.5, 3, 0.3});
  EXPECT_NEAR(at.distance, 0.3, 1e-15);
  EXPECT_NEAR(at.parameter_a, 0.75, 1e-15);
  EXPECT_NEAR(at.parameter_b, 0.25, 1e-15);
}

TEST(SegmentDistance, OfSegmentsThatMissEachOtherIsBetweenAnEndAndAPoint) {
  const auto at = closest_approach({0, 0, 0}, {1, 0, 0}, {3, -1, 0}, {3, 1, 0});
  EXPECT_NEAR(at.distance, 2, 1e-15);
  EXPECT_NEAR(at.parameter_a, 1, 1e-15);
  EXPECT_NEAR(at.parameter_b, 0.5, 1e-15);
}

TEST(SegmentDistance, OfParallelSegmentsIsTheirSpacingOrThatOfTheirEnds) {
  EXPECT_NEAR(closest_approach({0, 0, 0}, {4, 0, 0}, {1, 2, 0}, {9, 2, 0}).distance, 2, 1e-15);
  EXPECT_NEAR(closest_approach({0, 0, 0}, {4, 0, 0}, {9, 2, 0}, {1, 2, 0}).distance, 2, 1e-15);
  EXPECT_NEAR(closest_approach({0, 0, 0}, {4, 0, 0}, {7, 4, 0}, {9, 4, 0}).distance, 5, 1e-15);
}

TEST(SegmentDistance, OfPointsIsPlainDistance) {
  EXPECT_NEAR(closest_approach({0, 0, 0}, {0, 0, 0}, {3, 4, 0}, {3, 4, 0}).distance, 5, 1e-15);
  EXPECT_NEAR(closest_approach({2, 1, 0}, {2, 1, 0}, {0, 0, 0}, {9, 0, 0}).distance, 1, 1e-15);
}

/// Least distance by trying many pairs of points; never below the true one.
double by_trial(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1) {
  constexpr int n = 200;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double s = static_cast<double>(i) / n;
      const double t = static_cast<double>(j) / n;
      least = std::min(least, (a0 + s * (a1 - a0) - b0 - t * (b1 - b0)).norm());
    }
  }
  return least;
}

TEST(SegmentDistance, IsNeverAboveAndHardlyBelowThatOfManyTriedPairs) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] { return Vector3d(coordinate(random), coordinate(random), coordinate(random)); };
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3d a0 = point();
    const Vector3d a1 = point();
    const Vector3d b0 = point();
    const Vector3d b1 = point();
    const auto at = closest_approach(a0, a1, b0, b1);
    const double tried = by_trial(a0, a1, b0, b1);
    EXPECT_LE(at.distance, tried + 1e-12);
    EXPECT_GE(at.distance, tried - 0.02);
    const Vector3d between = a0 + at.parameter_a * (a1 - a0) - b0 - at.parameter_b * (b1 - b0);
    EXPECT_NEAR(between.norm(), at.distance, 1e-14);
  }
}

}  // namespace
}  // namespace knitmech::knit
