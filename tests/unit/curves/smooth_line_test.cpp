#include "curves/smooth_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/errors.h"
#include "curves/nearest_yarns.h"
#include "curves/read_lines.h"
#include "curves/write_lines.h"

namespace knitmech::curves {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 2, kPitch = 0.3;

/// A helix of radius R that rises by h a radian: its length is sqrt(R^2 + h^2) times the angle.
YarnLine helix(int n_points, double angle) {
  YarnLine yarn;
  for (int i = 0; i < n_points; ++i) {
    const double at = angle * i / (n_points - 1);
    yarn.points.emplace_back(kRadius * std::cos(at), kRadius * std::sin(at), kPitch * at);
  }
  return yarn;
}

const double kSpeed = std::hypot(kRadius, kPitch);

/// Largest distance of a line from the axis of the helix, less its radius.
double distance_from_helix(const AlongLine& line, double from, double to) {
  double largest = 0;
  for (int i = 0; i <= 500; ++i) {
    const Vector3d point = line.at(from + (to - from) * i / 500).point;
    largest = std::max(largest, std::abs(point.head<2>().norm() - kRadius));
  }
  return largest;
}

TEST(SmoothLine, GivenPointsOnAHelix_ThenTheSplineLiesOnItAndHasItsLength) {
  const double angle = 3 * std::numbers::pi;
  const AlongLine line(smooth_line(helix(97, angle), LineKind::through_points));
  // A cubic spline leaves a curve by 5/384 h^4 y'''' at most, with h = 0.2 here: 1e-6; its natural ends by more.
  EXPECT_LT(distance_from_helix(line, 2, line.length() - 2), 3e-6);
  EXPECT_NEAR(line.length(), angle * kSpeed, 2e-3);
}

TEST(SmoothLine, GivenPointsFarAndNear_ThenTheSplineDoesNotOvershoot) {
  YarnLine yarn = helix(97, 3 * std::numbers::pi);
  for (std::size_t i = 90; i > 3; i -= (i % 3) + 1) {
    yarn.points.erase(yarn.points.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const AlongLine line(smooth_line(yarn, LineKind::through_points));
  EXPECT_LT(distance_from_helix(line, 2, line.length() - 2), 2e-3);
}

TEST(SmoothLine, GivenAPointTwice_ThenTheSplineIsThatOfThePointOnce) {
  YarnLine yarn = helix(20, 2);
  const AlongLine once(smooth_line(yarn, LineKind::through_points));
  yarn.points.insert(yarn.points.begin() + 7, yarn.points[7]);
  const AlongLine twice(smooth_line(yarn, LineKind::through_points));
  EXPECT_EQ(once.length(), twice.length());
}

// The basis matrix of the uniform Catmull-Rom spline at the middle: (-p0 + 9 p1 + 9 p2 - p3) / 16.
TEST(SmoothLine, GivenControlPointsOfACatmullRomSpline_ThenItRunsFromTheSecondToTheLastButOne) {
  const YarnLine yarn{.points = {{0, 0, 0}, {1, 2, 0}, {3, 1, 1}, {4, 4, 0}, {5, 0, 2}}};
  const std::vector<CubicArc> arcs = smooth_line(yarn, LineKind::inner_points);
  ASSERT_EQ(arcs.size(), 2U);
  EXPECT_EQ(arcs.front().point(0), yarn.points[1]);
  EXPECT_EQ(arcs.back().point(1), yarn.points[3]);
  const auto& p = yarn.points;
  EXPECT_LT((arcs[0].point(0.5) - (-p[0] + 9 * p[1] + 9 * p[2] - p[3]) / 16).norm(), 1e-15);
  EXPECT_LT((arcs[1].point(0.5) - (-p[1] + 9 * p[2] + 9 * p[3] - p[4]) / 16).norm(), 1e-15);
  EXPECT_LT((arcs[0].derivative(1) - arcs[1].derivative(0)).norm(), 1e-15);
}

TEST(SmoothLine, GivenCornersOfYarns_ThenArcsTouchTheMiddlesOfTheirChords) {
  const YarnLine yarn{.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {4, 2, 0}}};
  const AlongLine line(smooth_line(yarn, LineKind::midpoints));
  EXPECT_EQ(line.at(0).point, yarn.points.front());
  EXPECT_EQ(line.at(line.length()).point, yarn.points.back());
  const std::vector<CubicArc> arcs = smooth_line(yarn, LineKind::midpoints);
  ASSERT_EQ(arcs.size(), 4U);
  EXPECT_EQ(arcs[1].point(0), Vector3d(1, 0, 0));
  EXPECT_EQ(arcs[1].point(1), Vector3d(2, 1, 0));
  // A parabola with this corner: a quarter of each end and half the corner.
  EXPECT_LT((arcs[1].point(0.5) - Vector3d(1.75, 0.25, 0)).norm(), 1e-15);
}

TEST(SmoothLine, GivenPointsThatAllCoincide_ThenItIsRefused) {
  const YarnLine yarn{.points = std::vector<Vector3d>(5, {1, 1, 1})};
  for (const LineKind kind : {LineKind::through_points, LineKind::inner_points, LineKind::midpoints}) {
    EXPECT_THROW(static_cast<void>(smooth_line(yarn, kind)), InputError);
  }
}

TEST(AlongLine, GivenALengthOnAHelix_ThenPointAndTangentAreThoseOfTheHelix) {
  const double angle = 2 * std::numbers::pi;
  const AlongLine line(smooth_line(helix(400, angle), LineKind::through_points));
  for (const double share : {0.2, 0.37, 0.5, 0.81}) {
    const AlongLine::Place place = line.at(share * line.length());
    const double at = share * angle;
    const Vector3d tangent(-kRadius * std::sin(at), kRadius * std::cos(at), kPitch);
    EXPECT_LT((place.point - Vector3d(kRadius * std::cos(at), kRadius * std::sin(at), kPitch * at)).norm(), 1e-4);
    EXPECT_LT((place.tangent - tangent / kSpeed).norm(), 1e-4);
    EXPECT_NEAR(place.tangent.norm(), 1, 1e-15);
  }
}

TEST(AlongLine, GivenEqualSteps_ThenThePiecesAreEquallyLong) {
  const YarnLine yarn{.points = {{0, 0, 0}, {0.1, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 1}, {0, 2.2, 1}}};
  const AlongLine line(smooth_line(yarn, LineKind::inner_points));
  const int n = 4000;
  double shortest = 1e9, longest = 0;
  Vector3d before = line.at(0).point;
  for (int i = 1; i <= n; ++i) {
    const Vector3d point = line.at(line.length() * i / n).point;
    shortest = std::min(shortest, (point - before).norm());
    longest = std::max(longest, (point - before).norm());
    before = point;
  }
  EXPECT_NEAR(longest, line.length() / n, 1e-6 * line.length() / n);
  EXPECT_NEAR(shortest, longest, 2e-3 * longest);  // chords of the bends
}

// What each of our files keeps of a line whose points stand as near as ten to a radius.
TEST(SmoothLine, GivenTheSameYarnInEveryFormat_ThenTheLinesLieWithinATenThousandthOfTheRadius) {
  const std::vector<YarnLine> yarns = {helix(60, 6)};
  const auto line_of = [](const YarnLines& lines) { return AlongLine(smooth_line(lines.yarns[0], lines.kind)); };
  for (const AlongLine& line : {line_of(parse_csv(csv_text(yarns))), line_of(parse_bcc(bcc_text(yarns))),
                                line_of(parse_yarns(yarns_text(yarns)))}) {
    EXPECT_LT(distance_from_helix(line, 1, line.length() - 1), 1e-4 * kRadius);
    EXPECT_NEAR(line.length(), 6 * kSpeed, 1e-3);
  }
}

std::vector<Vector3d> along_x(double y, double z) {
  std::vector<Vector3d> points;
  for (int i = 0; i <= 40; ++i) points.emplace_back(0.25 * i, y, z);
  return points;
}

TEST(NearestYarns, GivenTwoYarnsThatCross_ThenTheirPlacesAndDistanceAreFound) {
  std::vector<Vector3d> across;
  for (int i = 0; i <= 40; ++i) across.emplace_back(3.1, 0.25 * i - 5, 0.2);
  const auto nearest = nearest_yarns({along_x(0, 0), along_x(2, 0), across}, 0.1, 0.5);
  ASSERT_TRUE(nearest.has_value());
  EXPECT_NEAR(nearest->distance, 0.2, 1e-14);
  EXPECT_EQ(nearest->b.yarn, 2U);
  EXPECT_NEAR(nearest->a.arc_length, 3.1, 1e-12);
  EXPECT_NEAR(nearest->point.z(), 0.1, 1e-14);
}

TEST(NearestYarns, GivenYarnsFartherThanTheReach_ThenThereIsNone) {
  EXPECT_FALSE(nearest_yarns({along_x(0, 0), along_x(0.6, 0)}, 0.1, 0.5).has_value());
}

TEST(NearestYarns, GivenOneYarn_ThenOnlyWhereItComesBackCounts) {
  std::vector<Vector3d> straight = along_x(0, 0);
  EXPECT_FALSE(nearest_yarns({straight}, 0.6, 2).has_value());
  std::vector<Vector3d> hairpin = along_x(0, 0);
  for (int i = 40; i >= 0; --i) hairpin.emplace_back(0.25 * i, 0.4, 0);
  const auto nearest = nearest_yarns({hairpin}, 0.1, 2);
  ASSERT_TRUE(nearest.has_value());
  EXPECT_NEAR(nearest->distance, 0.4, 1e-14);
}

}  // namespace
}  // namespace knitmech::curves
