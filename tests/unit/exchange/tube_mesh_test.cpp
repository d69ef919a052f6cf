#include "exchange/tube_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/errors.h"
#include "exchange/constants.h"
#include "yarn_rows.h"

namespace knitmech::exchange {
namespace {

using Eigen::Vector3d;
using model::CurvePiece;

Vector3d corner(const TubeMesh& mesh, const std::array<TubeCorner, 3>& triangle, std::size_t i) {
  return mesh.points[triangle[i].point].cast<double>();
}

Vector3d area_vector(const TubeMesh& mesh, const std::array<TubeCorner, 3>& triangle) {
  const Vector3d a = corner(mesh, triangle, 0);
  return (corner(mesh, triangle, 1) - a).cross(corner(mesh, triangle, 2) - a) / 2;
}

/// By the divergence theorem; negative if the triangles face inwards.
double volume(const TubeMesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) sum += corner(mesh, triangle, 0).dot(area_vector(mesh, triangle)) / 3;
  return sum;
}

/// Area of the polygon of n corners on a circle.
double polygon_area(int sides, double radius) {
  return 0.5 * sides * std::sin(2 * std::numbers::pi / sides) * radius * radius;
}

/// Each edge once in each direction.
void expect_watertight(const TubeMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{triangle[i].point, triangle[(i + 1) % 3].point}];
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << edge.first << " to " << edge.second;
    ASSERT_TRUE(edges.contains({edge.second, edge.first})) << edge.first << " to " << edge.second;
  }
  // Euler's formula of a closed surface without holes.
  EXPECT_EQ(mesh.points.size() + mesh.triangles.size(), edges.size() / 2 + 2);
}

void expect_normals_outward(const TubeMesh& mesh) {
  for (const auto& triangle : mesh.triangles) {
    const Vector3d face = area_vector(mesh, triangle).normalized();
    for (const TubeCorner& each : triangle) {
      const Vector3d normal = mesh.normals[each.normal].cast<double>();
      EXPECT_NEAR(normal.norm(), 1, 1e-6);
      EXPECT_GT(normal.dot(face), 0.8);
    }
  }
}

TEST(TubeMesh, GivenAStraightYarn_ThenItIsThePrismOfThePolygon) {
  for (const int sides : {3, 4, 12, 64}) {
    const TubeMesh mesh = tube_mesh(straight_pieces(), sides);
    expect_watertight(mesh);
    EXPECT_NEAR(volume(mesh), polygon_area(sides, 0.1) * 6, 1e-6) << sides;  // points in single precision
    EXPECT_EQ(mesh.points.size(), 4U * static_cast<unsigned>(sides));
  }
  expect_normals_outward(tube_mesh(straight_pieces(), 12));
}

TEST(TubeMesh, GivenAStraightYarn_ThenItsPointsAreOnItsSurfaceAndItsEndsFlat) {
  const TubeMesh mesh = tube_mesh(straight_pieces(), 7);
  const Vector3d direction = Vector3d(1, 2, 2) / 3;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vector3d point = mesh.points[i].cast<double>();
    const Vector3d across = point - point.dot(direction) * direction;
    EXPECT_NEAR(across.norm(), 0.1, 1e-6);
    EXPECT_LT((mesh.normals[i].cast<double>() - across / 0.1).norm(), 1e-5);
  }
  const std::size_t n = mesh.points.size();
  EXPECT_LT((mesh.normals[n].cast<double>() + direction).norm(), 1e-6);
  EXPECT_LT((mesh.normals[n + 1].cast<double>() - direction).norm(), 1e-6);
}

// Pappus: the volume is the area of the section times the way of its centroid, here the length of the helix. The chords
// of the bend are inside of it, so a share of the order of kChordErrorShare r / R is missing, and never more is there.
TEST(TubeMesh, GivenAHelix_ThenItsVolumeIsThatOfPappus) {
  constexpr double kBend = 1, kClimb = 0.3, kRadius = 0.1;
  constexpr int kTurns = 3;
  const std::vector<CurvePiece> pieces = helix_pieces(kBend, kClimb, kTurns, kRadius);
  const double length = 2 * std::numbers::pi * kTurns * std::hypot(kBend, kClimb);
  for (const int sides : {3, 12, 48}) {
    const TubeMesh mesh = tube_mesh(pieces, sides);
    expect_watertight(mesh);
    const double expected = polygon_area(sides, kRadius) * length;
    EXPECT_LT(volume(mesh), expected);
    EXPECT_GT(volume(mesh), (1 - 3 * kChordErrorShare * kRadius / kBend) * expected) << sides;
  }
  expect_normals_outward(tube_mesh(pieces, 12));
}

TEST(TubeMesh, GivenAHelix_ThenEveryRingIsAcrossItAtItsRadius) {
  const std::vector<CurvePiece> pieces = helix_pieces(1, 0.3, 2, 0.1);
  const std::vector<YarnSample> samples = samples_of(pieces);
  const TubeMesh mesh = tube_mesh(pieces, 12);
  ASSERT_EQ(mesh.points.size(), 12 * samples.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const YarnSample& sample = samples[i / 12];
    const Vector3d across = mesh.points[i].cast<double>() - sample.point;
    EXPECT_NEAR(across.norm(), 0.1, 1e-6);
    EXPECT_NEAR(across.dot(sample.tangent), 0, 1e-6);
  }
}

// A frame without twist turns against the normal of a helix by its torsion times its length, climb / (R^2 + climb^2)
// times sqrt(R^2 + climb^2) times the angle: known in closed form.
TEST(TubeMesh, GivenAHelix_ThenItsRingsTurnByTheTorsionAlone) {
  constexpr double kBend = 1, kClimb = 0.5, kTurns = 2;
  const std::vector<CurvePiece> pieces = helix_pieces(kBend, kClimb, kTurns, 0.05);
  const std::vector<YarnSample> samples = samples_of(pieces);
  const TubeMesh mesh = tube_mesh(pieces, 12);
  const auto angle_to_normal = [&](std::size_t ring) {
    const YarnSample& sample = samples[ring];
    const Vector3d normal = -Vector3d(sample.point.x(), sample.point.y(), 0).normalized();
    const Vector3d first = mesh.normals[12 * ring].cast<double>();
    return std::atan2(first.dot(sample.tangent.cross(normal)), first.dot(normal));
  };
  const double turned = -kClimb / std::hypot(kBend, kClimb) * 2 * std::numbers::pi * kTurns;
  const double found = angle_to_normal(samples.size() - 1) - angle_to_normal(0);
  EXPECT_NEAR(std::remainder(found - turned, 2 * std::numbers::pi), 0, 1e-3);
}

TEST(TubeMesh, GivenAnElementWithoutLength_ThenTheTubeStaysWhole) {
  std::vector<CurvePiece> pieces = straight_pieces();
  pieces[1].end = pieces[1].start;
  pieces[1].start_tangent = pieces[1].end_tangent = Vector3d::Zero();
  pieces[2].start = pieces[1].end;
  const TubeMesh mesh = tube_mesh(pieces, 6);
  expect_watertight(mesh);
  EXPECT_TRUE(std::ranges::all_of(mesh.points, [](const auto& point) { return point.allFinite(); }));
  EXPECT_TRUE(std::ranges::all_of(mesh.normals, [](const auto& normal) { return normal.allFinite(); }));
}

TEST(TubeMesh, GivenASize_ThenItIsThatOfTheMesh) {
  const std::vector<CurvePiece> pieces = helix_pieces(1, 0.3, 1, 0.1);
  for (const int sides : {3, 12}) {
    const TubeMesh mesh = tube_mesh(pieces, sides);
    EXPECT_EQ(tube_size(pieces, sides).points, mesh.points.size());
    EXPECT_EQ(tube_size(pieces, sides).triangles, mesh.triangles.size());
  }
}

TEST(TubeRows, GivenAnotherDiameterFurtherOn_ThenThereIsATubeOfEach) {
  std::vector<CurvePiece> pieces = helix_pieces(1, 0, 1, 0.1);
  for (std::size_t i = 8; i < 20; ++i) pieces[i].radius = 0.05;
  const std::vector<YarnRow> rows = tube_rows(pieces);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].size(), 8U);
  EXPECT_EQ(rows[1].size(), 12U);
  EXPECT_EQ(rows[2].size(), 4U);
}

TEST(TubeFileSize, GivenMoreThan32BitsTell_ThenItIsRefusedWithAWayOut) {
  EXPECT_NO_THROW(check_file_size(0xffffffffU));
  try {
    check_file_size(0x100000000U);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--sides"), std::string::npos);
  }
}

}  // namespace
}  // namespace knitmech::exchange
