#include "base/segment_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace knitmech {
namespace {

/// The segment start + share along [mm].
struct Segment {
  Vector3 start;
  Vector3 along;

  [[nodiscard]] Vector3 at(double share) const { return start + share * along; }
};

Segment between(Vector3 start, Vector3 end) {
  return {start, end - start};
}

ClosestPoints closest(const Segment& a, const Segment& b) {
  return closest_points(a.start, a.along, b.start, b.along);
}

double distance(const Segment& a, const Segment& b) {
  const ClosestPoints at = closest(a, b);
  return length(b.at(at.t) - a.at(at.s));
}

TEST(ClosestPoints, GivenCrossingSegments_ThenTheyLieOnTheCommonNormal) {
  const Segment a = between({-1, 0, 0}, {1, 0, 0});
  const Segment b = between({0.5, -1, 0.3}, {0.5, 3, 0.3});
  EXPECT_NEAR(closest(a, b).s, 0.75, 1e-15);
  EXPECT_NEAR(closest(a, b).t, 0.25, 1e-15);
  EXPECT_NEAR(distance(a, b), 0.3, 1e-15);
}

TEST(ClosestPoints, GivenSegmentsThatMissEachOther_ThenOneIsAnEnd) {
  const Segment a = between({0, 0, 0}, {1, 0, 0});
  const Segment b = between({3, -1, 0}, {3, 1, 0});
  EXPECT_NEAR(closest(a, b).s, 1, 1e-15);
  EXPECT_NEAR(closest(a, b).t, 0.5, 1e-15);
  EXPECT_NEAR(distance(a, b), 2, 1e-15);
}

TEST(ClosestPoints, GivenTheSegmentsSwapped_ThenTheAnswerIsSwapped) {
  const Segment a = {{0, 0, 0}, {1, 0.2, 0}};
  const Segment b = {{0.3, -1, 0.4}, {0.1, 2, 0.1}};
  EXPECT_NEAR(closest(a, b).s, closest(b, a).t, 1e-14);
  EXPECT_NEAR(closest(a, b).t, closest(b, a).s, 1e-14);
}

TEST(ClosestPoints, GivenParallelSegmentsSideBySide_ThenTheyAreTheMiddleOfTheOverlap) {
  const Segment a = between({0, 0, 0}, {4, 0, 0});
  EXPECT_NEAR(closest(a, between({1, 1, 0}, {3, 1, 0})).s, 0.5, 1e-15);  // overlap from 1 to 3
  EXPECT_NEAR(closest(a, between({1, 1, 0}, {3, 1, 0})).t, 0.5, 1e-15);
  EXPECT_NEAR(closest(a, between({9, 2, 0}, {1, 2, 0})).s, 0.625, 1e-15);  // overlap from 1 to 4, b runs the other way
  EXPECT_NEAR(closest(a, between({9, 2, 0}, {1, 2, 0})).t, 0.8125, 1e-15);
}

TEST(ClosestPoints, GivenParallelSegmentsOneBehindTheOther_ThenTheyAreEnds) {
  const Segment a = between({0, 0, 0}, {4, 0, 0});
  EXPECT_NEAR(distance(a, between({7, 4, 0}, {9, 4, 0})), 5, 1e-15);
  EXPECT_NEAR(distance(a, between({9, 4, 0}, {7, 4, 0})), 5, 1e-15);
}

TEST(ClosestPoints, GivenSegmentsOfNoLength_ThenTheyArePoints) {
  const Segment origin = {{0, 0, 0}, {0, 0, 0}};
  const Segment point = {{3, 4, 0}, {0, 0, 0}};
  const Segment axis = between({0, 0, 0}, {9, 0, 0});
  EXPECT_NEAR(distance(origin, point), 5, 1e-15);
  EXPECT_NEAR(distance(axis, point), 4, 1e-15);
  EXPECT_NEAR(distance(point, axis), 4, 1e-15);
  EXPECT_NEAR(closest(axis, point).s, 3.0 / 9, 1e-15);
  EXPECT_NEAR(closest(point, axis).t, 3.0 / 9, 1e-15);
}

class SmallAngle : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Radians, SmallAngle, testing::Values(1e-2, 1e-4, 1e-6, 1e-8, 1e-9));

TEST_P(SmallAngle, BetweenTheSegmentsLeavesTheCrossingExact) {
  // Given two segments that run the same way but for this angle, and cross at shares 0.3 and 0.6 at a distance of 0.1
  // mm, then this is found: only the components across, of the size of the angle, tell where.
  const double angle = GetParam();
  const Segment a = {{0, 0, 0}, {1, 0, 0}};
  const Vector3 along_b = {std::cos(angle), std::sin(angle), 0};
  const Segment b = {a.at(0.3) + Vector3{0, 0, 0.1} - 0.6 * along_b, along_b};
  const double rounding = 1e-15 / angle;
  EXPECT_NEAR(closest(a, b).s, 0.3, rounding);
  EXPECT_NEAR(closest(a, b).t, 0.6, rounding);
  EXPECT_NEAR(distance(a, b), 0.1, 1e-15);
}

/// Least distance over a fine grid of both segments: slow and plain, never below the true one.
double by_trial(const Segment& a, const Segment& b) {
  constexpr int n = 200;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= n; ++i) {
    const Vector3 on_a = a.at(static_cast<double>(i) / n);
    for (int j = 0; j <= n; ++j) least = std::min(least, length(b.at(static_cast<double>(j) / n) - on_a));
  }
  return least;
}

TEST(ClosestPoints, GivenRandomSegments_ThenNoPairOfPointsIsNearer) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] {
    const double x = uniform(random);
    const double y = uniform(random);
    return Vector3{x, y, uniform(random)};
  };
  for (int trial = 0; trial < 500; ++trial) {
    const Segment a = {vector(), vector()};
    const Segment b = {vector(), trial % 5 == 0 ? -0.7 * a.along : vector()};  // every fifth pair is parallel
    const double tried = by_trial(a, b);
    EXPECT_LE(distance(a, b), tried + 1e-12) << "trial " << trial;
    EXPECT_GE(distance(a, b), tried - 0.01) << "trial " << trial;  // half a step of the grid on both, 2 x 0.005 x 0.9
  }
}

}  // namespace
}  // namespace knitmech
