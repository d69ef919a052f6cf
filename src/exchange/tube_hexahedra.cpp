#include "exchange/tube_hexahedra.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "exchange/constants.h"
#include "exchange/yarn_samples.h"

namespace knitmech::exchange {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Nodes of the section: corners of the inner square 0 to 3, of the outline 4 to 7; then middles of the sides of the
// inner square 8 to 11, of the outline 12 to 15, and of the lines from one to the other 16 to 19.
constexpr int kOutline = 4, kInnerSides = 8, kArcs = 12, kSpokes = 16;

/// Area of the four parabolas over that of the circle through their ends and tops: each quarter is a right triangle
/// and two thirds of chord times height.
double area_share() {
  const double chord = std::numbers::sqrt2, height = 1 - chord / 2;
  return 4 * (0.5 + 2.0 / 3 * chord * height) / std::numbers::pi;
}

std::array<Vector2d, kSectionNodes> section_of_radius(double radius) {
  const double outer = radius / std::sqrt(area_share());
  const double inner = kCoreShare * outer;
  const auto at = [](double distance, double quarters) {
    const double angle = std::numbers::pi / 2 * quarters;
    return Vector2d(distance * std::cos(angle), distance * std::sin(angle));
  };
  std::array<Vector2d, kSectionNodes> nodes;
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    nodes[k] = at(inner, i + 0.5);
    nodes[kOutline + k] = at(outer, i + 0.5);
    nodes[kInnerSides + k] = at(inner / std::numbers::sqrt2, i + 1);
    nodes[kArcs + k] = at(outer, i + 1);
    nodes[kSpokes + k] = at(0.5 * (inner + outer), i + 0.5);
  }
  return nodes;
}

/// Corners, then middles of the sides, counterclockwise; side 1 of those around is on the outline.
std::array<std::array<int, 8>, kSectionQuads> section_quads() {
  std::array<std::array<int, 8>, kSectionQuads> quads{{{0, 1, 2, 3, 8, 9, 10, 11}}};
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    quads[static_cast<std::size_t>(i) + 1] = {i,           kOutline + i, kOutline + next, next,
                                              kSpokes + i, kArcs + i,    kSpokes + next,  kInnerSides + i};
  }
  return quads;
}

void add_ring(TubeHexahedra& tube, const PathPoint& place, const Vector3d& across,
              const std::array<Vector2d, kSectionNodes>& section, int count) {
  const Vector3d other = place.tangent.cross(across);
  std::vector<int>& ring = tube.rings.emplace_back();
  for (int i = 0; i < count; ++i) {
    const Vector2d& offset = section[static_cast<std::size_t>(i)];
    ring.push_back(static_cast<int>(tube.nodes.size()));
    tube.nodes.emplace_back(place.point + offset.x() * across + offset.y() * other);
  }
}

/// The hexahedra between the rings i and i + 2; those of the middle are the nodes halfway along the edges.
void add_elements(TubeHexahedra& tube, std::size_t i) {
  const std::vector<int>&start = tube.rings[i], &middle = tube.rings[i + 1], &end = tube.rings[i + 2];
  for (const std::array<int, 8>& quad : section_quads()) {
    std::array<int, 20> element{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto corner = static_cast<std::size_t>(quad[k]), side = static_cast<std::size_t>(quad[k + 4]);
      element[k] = start[corner];
      element[k + 4] = end[corner];
      element[k + 8] = start[side];
      element[k + 12] = end[side];
      element[k + 16] = middle[corner];
    }
    tube.elements.push_back(element);
  }
}

}  // namespace

TubeHexahedra tube_hexahedra(const YarnPath& path, double radius) {
  TubeHexahedra tube;
  tube.yarn = path.yarn;
  const auto section = section_of_radius(radius);
  Vector3d across = path.points.front().tangent.unitOrthogonal();
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const PathPoint& here = path.points[i];
    if (i > 0) {
      const PathPoint& before = path.points[i - 1];
      across = carried_across(across, {before.point, before.tangent}, {here.point, here.tangent});
    }
    add_ring(tube, here, across, section, i % 2 == 0 ? kSectionNodes : kMiddleNodes);
    if (i % 2 == 0 && i > 0) add_elements(tube, i - 2);
  }
  return tube;
}

}  // namespace knitmech::exchange
