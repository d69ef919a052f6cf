#include "contact/segment_distance.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace knitmech::contact {
namespace {

double distance_at(Vector3 a, Vector3 u, Vector3 b, Vector3 v, double s, double t) {
  return length(b + t * v - a - s * u);
}

/// Least distance over a fine grid of both segments: slow and plain.
double brute_force(Vector3 a, Vector3 u, Vector3 b, Vector3 v) {
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i <= 200; ++i) {
    for (int j = 0; j <= 200; ++j) least = std::min(least, distance_at(a, u, b, v, i / 200.0, j / 200.0));
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
    const Vector3 a = vector();
    const Vector3 u = vector();
    const Vector3 b = vector();
    const Vector3 v = trial % 5 == 0 ? -0.7 * u : vector();  // every fifth pair is parallel
    const ClosestPoints at = closest_points(a, u, b, v);
    const double found = distance_at(a, u, b, v, at.s, at.t);
    const double reference = brute_force(a, u, b, v);
    EXPECT_LE(found, reference + 1e-12) << "trial " << trial;
    EXPECT_GE(found, reference - 0.01) << "trial " << trial;
  }
}

TEST(ClosestPoints, GivenParallelSegments_ThenTheMiddleOfTheirOverlapIsTaken) {
  const ClosestPoints at = closest_points({0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {2, 0, 0});
  EXPECT_NEAR(at.s, 0.5, 1e-14);  // overlap from 1 to 3
  EXPECT_NEAR(at.t, 0.5, 1e-14);
}

TEST(ClosestPoints, GivenTheSegmentsSwapped_ThenTheAnswerIsSwapped) {
  const ClosestPoints one = closest_points({0, 0, 0}, {1, 0.2, 0}, {0.3, -1, 0.4}, {0.1, 2, 0.1});
  const ClosestPoints two = closest_points({0.3, -1, 0.4}, {0.1, 2, 0.1}, {0, 0, 0}, {1, 0.2, 0});
  EXPECT_NEAR(one.s, two.t, 1e-14);
  EXPECT_NEAR(one.t, two.s, 1e-14);
}

}  // namespace
}  // namespace knitmech::contact
