#include "contact/gauss_integral.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace knitmech::contact {
namespace {

constexpr Vector3 kOffset{5e-8, 3e-8, 8e-8};

/// The definition, by five Gauss points on each of n parts of both segments.
double double_integral(const Segment& a, const Segment& b, int n) {
  struct Point {
    double node, weight;
  };
  constexpr std::array<Point, 5> kGauss{{{-0.906179845938664, 0.236926885056189},
                                         {-0.538469310105683, 0.478628670499366},
                                         {0, 0.568888888888889},
                                         {0.538469310105683, 0.478628670499366},
                                         {0.906179845938664, 0.236926885056189}}};
  std::vector<Point> points;  // on [0, 1]
  points.reserve(kGauss.size() * static_cast<std::size_t>(n));
  for (int part = 0; part < n; ++part) {
    for (const Point& gauss : kGauss) points.push_back({(part + 0.5 * (1 + gauss.node)) / n, 0.5 * gauss.weight / n});
  }
  const Vector3 u = a.end - a.start;
  const Vector3 v = b.end - b.start;
  double sum = 0;
  for (const Point& s : points) {
    for (const Point& t : points) {
      const Vector3 between = a.start + s.node * u - b.start - t.node * v;
      sum += s.weight * t.weight * dot(cross(u, v), between) / std::pow(length(between), 3);
    }
  }
  return sum / (4 * std::numbers::pi);
}

template <typename Curve>
std::vector<Vector3> closed_polyline(const Curve& curve, int n) {
  std::vector<Vector3> points;
  points.reserve(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i < n; ++i) points.push_back(curve(2 * std::numbers::pi * i / n));
  points.push_back(points.front());
  return points;
}

/// A segment that moves without turning.
MovedSegment moved(const Segment& segment, Vector3 by) {
  return {segment, {segment.start + by, segment.end + by}};
}
MovedSegment at_rest(const Segment& segment) {
  return moved(segment, {0, 0, 0});
}

TEST(GaussIntegral, GivenRandomSegments_ThenItIsTheDoubleIntegralOfItsDefinition) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(-1, 1);
  for (int trial = 0; trial < 30; ++trial) {
    const auto point = [&](double z) {
      const double x = at(random);
      return Vector3{x, at(random), z};
    };
    const Segment a{point(0.3), point(0.5)};
    const Segment b{point(0), point(-0.2)};
    EXPECT_NEAR(gauss_integral(a, b), double_integral(a, b, 20), 1e-10);
    EXPECT_NEAR(gauss_integral(b, a), gauss_integral(a, b), 1e-15);
  }
}

TEST(GaussIntegral, GivenACrossAtAHeight_ThenItIsTheSolidAngleOfASquareOverFourPi) {
  for (const double height : {0.01, 0.5, 1.0, 7.0}) {
    const Segment lower{{-1, 0, 0}, {1, 0, 0}};
    const Segment upper{{0, -1, height}, {0, 1, height}};
    // Square of side 2 seen from a point a height above its middle: 4 asin(1 / (1 + h^2)).
    EXPECT_NEAR(std::abs(gauss_integral(lower, upper)), std::asin(1 / (1 + height * height)) / std::numbers::pi, 1e-14);
    const Segment below{{0, -1, -height}, {0, 1, -height}};
    EXPECT_NEAR(gauss_integral(lower, below), -gauss_integral(lower, upper), 1e-15);
  }
}

TEST(GaussIntegral, GivenClosedPolylines_ThenItIsTheirLinkingNumber) {
  const auto circle = [](double p) { return Vector3{std::cos(p), std::sin(p), 0}; };
  const auto through = [](double p) { return Vector3{1 + std::cos(p), 0, std::sin(p)}; };
  const auto beside = [](double p) { return Vector3{2.2 + std::cos(p), 0, std::sin(p)}; };
  const auto three_times_around = [](double p) {
    const double r = 1 + 0.4 * std::cos(3 * p);
    return Vector3{r * std::cos(p), r * std::sin(p), 0.4 * std::sin(3 * p)};
  };
  const auto ring = closed_polyline(circle, 60);
  auto reversed = ring;
  std::reverse(reversed.begin(), reversed.end());
  const double linked = gauss_integral(ring, closed_polyline(through, 50));
  EXPECT_NEAR(std::abs(linked), 1, 1e-12);
  EXPECT_NEAR(gauss_integral(reversed, closed_polyline(through, 50)), -linked, 1e-12);
  EXPECT_NEAR(gauss_integral(ring, closed_polyline(beside, 50)), 0, 1e-12);
  EXPECT_NEAR(std::abs(gauss_integral(ring, closed_polyline(three_times_around, 90))), 3, 1e-12);
}

TEST(GaussIntegral, GivenSegmentsInOnePlaneOrOfNoLength_ThenItIsZero) {
  const Segment a{{0, 0, 0}, {1, 0, 0}};
  for (const Segment& b :
       {Segment{{0, 1, 0}, {1, 1, 0}}, Segment{{2, 0, 0}, {3, 0, 0}}, Segment{{1.5, -1, 0}, {2, 3, 0}},
        Segment{{0.5, 0, 1}, {0.5, 0, 1}}, Segment{{0.3, 0.1, 0}, {0.7, 0.1, 0}}}) {
    EXPECT_NEAR(gauss_integral(a, b), 0, 1e-15);
  }
  // Segments that meet in an end, lie on each other, or are the same point still give a number.
  for (const Segment& b :
       {Segment{{1, 0, 0}, {1, 1, 0}}, Segment{{0.5, 0, 0}, {2, 0, 0}}, a, Segment{{0, 0, 0}, {0, 0, 0}}}) {
    EXPECT_LE(std::abs(gauss_integral(a, b)), 0.5);
  }
}

TEST(Passes, GivenOneSegmentMovedThroughAnother_ThenThereIsOneWhoseSignIsTheJumpOfTheIntegral) {
  const Segment a{{-1, 0, 0}, {1, 0, 0}};
  const Segment b{{0.2, -1, 0.1}, {0.3, 1, 0.2}};
  const MovedSegment down = moved(b, {0, 0, -0.3});
  const double jump = gauss_integral(a, down.now) - gauss_integral(a, b);
  ASSERT_GT(std::abs(jump), 0.5);
  EXPECT_EQ(passes(at_rest(a), down, kOffset), jump > 0 ? 1 : -1);
  EXPECT_EQ(passes(at_rest(a), {down.now, b}, kOffset), jump > 0 ? -1 : 1);
  EXPECT_EQ(passes(down, at_rest(a), kOffset), jump > 0 ? 1 : -1);
}

TEST(Passes, GivenSegmentsThatStayOnTheirSides_ThenThereIsNone) {
  const Segment a{{-1, 0, 0}, {1, 0, 0}};
  const Segment b{{0, -1, 0.1}, {0, 1, 0.1}};
  EXPECT_EQ(passes(at_rest(a), at_rest(b), kOffset), 0);
  EXPECT_EQ(passes(at_rest(a), moved(b, {0, 0, -0.0999}), kOffset), 0);
  // Past the end of a, and down beside it: not through it.
  EXPECT_EQ(passes(at_rest(a), moved({{1.01, -1, 0.1}, {1.01, 1, 0.1}}, {0, 0, -0.3}), kOffset), 0);
  // Both moved far together.
  EXPECT_EQ(passes(moved(a, {3, 2, -5}), moved(b, {3, 2, -5}), kOffset), 0);
  // Turned to lie along a, just above it: the integral falls from almost 1/2 to 0, yet nothing has passed.
  const MovedSegment turned{{{0, -1, 1e-3}, {0, 1, 1e-3}}, {{-1, 1e-4, 1e-3}, {1, -1e-4, 1e-3}}};
  ASSERT_GT(std::abs(gauss_integral(a, turned.now) - gauss_integral(a, turned.before)), 0.4);
  EXPECT_EQ(passes(at_rest(a), turned, kOffset), 0);
}

TEST(Passes, GivenClosedPolylinesMovedAtRandom_ThenTheirSumIsTheChangeOfTheLinkingNumber) {
  // Every node moves on its own, through everything: passes at common nodes must be counted once.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-1, 1);
  const auto polyline = [&](int n) {
    std::vector<Vector3> points;
    for (int i = 0; i < n; ++i) {
      const double x = at(random);
      const double y = at(random);
      points.push_back({x, y, at(random)});
    }
    points.push_back(points.front());
    return points;
  };
  int n_changes = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto a_before = polyline(7);
    const auto a_now = polyline(7);
    const auto b_before = polyline(6);
    const auto b_now = polyline(6);
    int sum = 0;
    for (std::size_t i = 0; i < 7; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        sum += passes({{a_before[i], a_before[i + 1]}, {a_now[i], a_now[i + 1]}},
                      {{b_before[j], b_before[j + 1]}, {b_now[j], b_now[j + 1]}}, kOffset);
      }
    }
    EXPECT_NEAR(gauss_integral(a_now, b_now) - gauss_integral(a_before, b_before), sum, 1e-9);
    n_changes += sum != 0 ? 1 : 0;
  }
  EXPECT_GT(n_changes, 200);
}

TEST(Passes, GivenAPassExactlyThroughACommonNode_ThenOneOfBothSegmentsCountsIt) {
  const Segment left{{-1, 0.3, 0}, {0, 0, 0}};
  const Segment right{{0, 0, 0}, {1, 0.2, 0}};
  const MovedSegment across = moved({{0, -1, 0.5}, {0, 1, 0.5}}, {0, 0, -1});
  EXPECT_EQ(std::abs(passes(at_rest(left), across, kOffset) + passes(at_rest(right), across, kOffset)), 1);
  // Two nodes that hit each other.
  const Vector3 tip{0, 0, 0.5};
  int sum = 0;
  for (const Segment& a : {left, right}) {
    for (const Segment& b : {Segment{{0.1, -1, 0.5}, tip}, Segment{tip, {-0.1, 1, 0.5}}}) {
      sum += passes(at_rest(a), moved(b, {0, 0, -1}), kOffset);
    }
  }
  EXPECT_EQ(std::abs(sum), 1);
}

TEST(Passes, GivenAMotionThatStopsExactlyWhereTheyMeet_ThenOneOfBothPartsOfItCountsThePass) {
  const Segment a{{-1, 0, 0}, {1, 0, 0}};
  const MovedSegment down = moved({{0, -1, 0.25}, {0, 1, 0.25}}, {0, 0, -0.25});
  const MovedSegment on = moved(down.now, {0, 0, -0.25});
  EXPECT_EQ(std::abs(passes(at_rest(a), down, kOffset) + passes(at_rest(a), on, kOffset)), 1);
  const MovedSegment back{down.now, down.before};
  EXPECT_EQ(passes(at_rest(a), down, kOffset) + passes(at_rest(a), back, kOffset), 0);
}

}  // namespace
}  // namespace knitmech::contact
