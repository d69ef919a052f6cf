#include "exchange/tube_hexahedra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hexahedron.h"

namespace knitmech::exchange {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kRadius = 0.06;

/// A yarn of elements along x, or along a quarter circle about z of a radius.
YarnPath straight_path(int elements, double length) {
  YarnPath path;
  for (int i = 0; i <= 2 * elements; ++i) {
    path.points.push_back({Vector3d(length * i / (2 * elements), 0, 0), Vector3d(1, 0, 0), 0, 0, Grip::none});
  }
  return path;
}

YarnPath quarter_circle(int elements, double radius) {
  YarnPath path;
  for (int i = 0; i <= 2 * elements; ++i) {
    const double angle = pi / 2 * i / (2 * elements);
    path.points.push_back({radius * Vector3d(std::cos(angle), std::sin(angle), 0),
                           Vector3d(-std::sin(angle), std::cos(angle), 0), 0, 0, Grip::none});
  }
  return path;
}

std::array<Vector3d, 20> corners_of(const TubeHexahedra& tube, const std::array<int, 20>& element) {
  std::array<Vector3d, 20> corners;
  for (std::size_t i = 0; i < 20; ++i) corners[i] = tube.nodes[static_cast<std::size_t>(element[i])];
  return corners;
}

double integral(const TubeHexahedra& tube, int n, const std::function<double(const Vector3d&)>& function,
                double& least) {
  double sum = 0;
  for (const std::array<int, 20>& element : tube.elements) {
    sum += test::integrate_over(corners_of(tube, element), n, least, function);
  }
  return sum;
}

TEST(TubeHexahedra, GivenAStraightYarn_ThenVolumeAndSecondMomentsAreThoseOfTheCircle) {
  const TubeHexahedra tube = tube_hexahedra(straight_path(4, 1.0), kRadius);
  double least = std::numeric_limits<double>::infinity();
  const double area = pi * kRadius * kRadius, second_moment = area * kRadius * kRadius / 4;
  const auto one = [](const Vector3d&) { return 1.0; };
  const auto along_y = [](const Vector3d& at) { return at.y() * at.y(); };
  const auto along_z = [](const Vector3d& at) { return at.z() * at.z(); };
  EXPECT_NEAR(integral(tube, 3, one, least), area, 1e-12 * area);
  // What the points of C3D20R see.
  EXPECT_NEAR(integral(tube, 2, one, least), area, 1e-3 * area);
  EXPECT_NEAR(integral(tube, 2, along_y, least), second_moment, 3e-4 * second_moment);
  EXPECT_NEAR(integral(tube, 2, along_z, least), second_moment, 3e-4 * second_moment);
  EXPECT_GT(least, 0);
}

TEST(TubeHexahedra, GivenAQuarterCircle_ThenNoElementIsFoldedAndTheVolumeIsThatOfPappus) {
  const double radius = 0.3;  // of the centreline: five yarn radii
  const TubeHexahedra tube = tube_hexahedra(quarter_circle(6, radius), kRadius);
  double least = std::numeric_limits<double>::infinity();
  const double volume = integral(
      tube, 3, [](const Vector3d&) { return 1.0; }, least);
  const double expected = pi * kRadius * kRadius * radius * pi / 2;
  EXPECT_NEAR(volume, expected, 2e-3 * expected);  // quadratic sides instead of arcs
  EXPECT_GT(least, 0);
}

TEST(TubeHexahedra, GivenAYarn_ThenEveryRingHasItsCentreInTheMiddleOfTheFirstFourNodes) {
  const YarnPath path = quarter_circle(6, 0.3);
  const TubeHexahedra tube = tube_hexahedra(path, kRadius);
  ASSERT_EQ(tube.rings.size(), path.points.size());
  for (std::size_t i = 0; i < tube.rings.size(); ++i) {
    ASSERT_EQ(tube.rings[i].size(), static_cast<std::size_t>(i % 2 == 0 ? kSectionNodes : kMiddleNodes));
    Vector3d middle(0, 0, 0);
    for (std::size_t k = 0; k < 4; ++k) middle += tube.nodes[static_cast<std::size_t>(tube.rings[i][k])] / 4;
    EXPECT_NEAR((middle - path.points[i].point).norm(), 0, 1e-14);
    for (const int node : tube.rings[i]) {
      const Vector3d from_middle = tube.nodes[static_cast<std::size_t>(node)] - middle;
      EXPECT_NEAR(from_middle.dot(path.points[i].tangent), 0, 1e-14);
    }
  }
}

TEST(TubeHexahedra, GivenTheOuterElements_ThenTheirFourthFaceIsOnTheSurfaceOfTheYarn) {
  const TubeHexahedra tube = tube_hexahedra(straight_path(2, 0.5), kRadius);
  ASSERT_EQ(kOuterFace, 4);
  constexpr std::array<std::size_t, 8> on_face_4{1, 2, 5, 6, 9, 13, 17, 18};  // CalculiX: corners 2, 3, 7 and 6
  for (std::size_t i = 0; i < tube.elements.size(); ++i) {
    if (i % kSectionQuads == 0) continue;
    for (const std::size_t k : on_face_4) {
      const Vector3d& node = tube.nodes[static_cast<std::size_t>(tube.elements[i][k])];
      EXPECT_NEAR(std::hypot(node.y(), node.z()), kRadius, 0.007 * kRadius);
    }
  }
}

}  // namespace
}  // namespace knitmech::exchange
