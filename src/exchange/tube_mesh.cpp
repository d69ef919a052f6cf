#include "exchange/tube_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "exchange/constants.h"

namespace knitmech::exchange {
namespace {

using Eigen::Vector3d;
using model::CurvePiece;

void add_ring(TubeMesh& mesh, const YarnSample& sample, const Vector3d& across, double radius) {
  const Vector3d other = sample.tangent.cross(across);
  for (std::uint32_t side = 0; side < mesh.sides; ++side) {
    const double angle = 2 * std::numbers::pi * side / mesh.sides;
    const Vector3d outward = std::cos(angle) * across + std::sin(angle) * other;
    mesh.points.emplace_back((sample.point + radius * outward).cast<float>());
    mesh.normals.emplace_back(outward.cast<float>());
  }
}

/// The wall between the ring that begins at a point and the next one. A point of it has the normal of the same number.
void add_wall(TubeMesh& mesh, std::uint32_t first) {
  for (std::uint32_t side = 0; side < mesh.sides; ++side) {
    const std::uint32_t a = first + side, b = first + (side + 1) % mesh.sides;
    const std::uint32_t a_next = a + mesh.sides, b_next = b + mesh.sides;
    mesh.triangles.push_back({{{a, a}, {b, b}, {b_next, b_next}}});
    mesh.triangles.push_back({{{a, a}, {b_next, b_next}, {a_next, a_next}}});
  }
}

void add_end(TubeMesh& mesh, std::uint32_t first, const Vector3d& outward, bool is_last) {
  const auto normal = static_cast<std::uint32_t>(mesh.normals.size());
  mesh.normals.emplace_back(outward.cast<float>());
  for (std::uint32_t side = 1; side + 1 < mesh.sides; ++side) {
    const std::uint32_t b = first + side + (is_last ? 0 : 1), c = first + side + (is_last ? 1 : 0);
    mesh.triangles.push_back({{{first, normal}, {b, normal}, {c, normal}}});
  }
}

std::uint64_t n_rings(YarnRow row) {
  std::uint64_t steps = 0;
  for (const CurvePiece& piece : row) steps += static_cast<std::uint64_t>(steps_of(piece));
  return steps + 1;
}

}  // namespace

std::vector<YarnRow> tube_rows(const std::vector<CurvePiece>& pieces) {
  std::vector<YarnRow> tubes;
  for (YarnRow rest : yarn_rows(pieces)) {
    while (!rest.empty()) {
      const double radius = rest.front().radius;
      const auto end = std::ranges::find_if(rest, [&](const CurvePiece& piece) { return piece.radius != radius; });
      const auto length = static_cast<std::size_t>(end - rest.begin());
      tubes.push_back(rest.first(length));
      rest = rest.subspan(length);
    }
  }
  return tubes;
}

TubeMesh tube_mesh(YarnRow row, int sides) {
  TubeMesh mesh;
  mesh.yarn = row.front().yarn;
  mesh.sides = static_cast<std::uint32_t>(sides);
  const TubeSize size = tube_size(row, sides);
  mesh.points.reserve(size.points);
  mesh.normals.reserve(size.points + 2);
  mesh.triangles.reserve(size.triangles);
  const std::vector<YarnSample> samples = samples_of(row);
  Vector3d across = samples.front().tangent.unitOrthogonal();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i > 0) across = carried_across(across, samples[i - 1], samples[i]);
    add_ring(mesh, samples[i], across, row.front().radius);
    if (i > 0) add_wall(mesh, static_cast<std::uint32_t>((i - 1) * mesh.sides));
  }
  add_end(mesh, 0, -samples.front().tangent, false);
  add_end(mesh, static_cast<std::uint32_t>((samples.size() - 1) * mesh.sides), samples.back().tangent, true);
  return mesh;
}

TubeSize tube_size(YarnRow row, int sides) {
  const auto n = static_cast<std::uint64_t>(sides);
  const std::uint64_t rings = n_rings(row);
  return {.points = rings * n, .triangles = 2 * n * (rings - 1) + 2 * (n - 2)};
}

void check_file_size(std::uint64_t bytes) {
  if (bytes <= kMostFileBytes) return;
  throw InputError(
      fmt::format("the tubes of this fabric would fill more than {:.1f} GB in this format, {:.1f} GB is the most; give "
                  "them fewer --sides, or write lines, as -f vtp does",
                  static_cast<double>(bytes) / 1e9, static_cast<double>(kMostFileBytes) / 1e9));
}

}  // namespace knitmech::exchange
