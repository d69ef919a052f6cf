#include <Eigen/Core>
#include <cstdint>

#include "curves/bytes.h"
#include "curves/write_lines.h"
#include "curves/yarns_format.h"

namespace knitmech::curves {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// Where the arc around a corner is nearest to it, it is at (corner before + 6 corner + corner after) / 8.
constexpr double kCornerShare = 6.0 / 8;
constexpr double kNeighbourShare = 1.0 / 8;

/// Corners c with c0 = q0, cn = qn and (c[i-1] + 6 c[i] + c[i+1]) / 8 = q[i] between, by elimination (Thomas).
Points corners_of_open(const Points& on_curve) {
  Points corners = on_curve;
  std::vector<double> above(on_curve.size(), 0);  // what is left of the share of the next corner
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const double pivot = kCornerShare - kNeighbourShare * above[i - 1];
    above[i] = kNeighbourShare / pivot;
    corners[i] = (corners[i] - kNeighbourShare * corners[i - 1]) / pivot;
  }
  for (std::size_t i = corners.size() - 1; i-- > 1;) {
    corners[i] -= above[i] * corners[i + 1];
  }
  return corners;
}

/// Corners of the arcs through the points. A closed yarn is opened with so much of it repeated at both ends that what
/// holds there is not felt between: the influence of a point falls to a sixth from one to the next.
Points corners_of(const YarnLine& yarn) {
  if (!yarn.closed) return corners_of_open(yarn.points);
  constexpr std::size_t kOverlap = 24;
  const std::size_t n = yarn.points.size();
  Points around;
  for (std::size_t i = 0; i < n + 2 * kOverlap + 1; ++i) {
    around.push_back(yarn.points[(i + n * kOverlap - kOverlap) % n]);
  }
  const Points corners = corners_of_open(around);
  Points once(corners.begin() + kOverlap, corners.begin() + static_cast<std::ptrdiff_t>(kOverlap + n));
  once.push_back(once.front());
  return once;
}

void put_chunk(std::string& bytes, const YarnsChunk& chunk, const std::string& content) {
  bytes += chunk.name;
  put(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += content;
}

/// The unit that every file has: named "1" and 1 long.
std::string unit_of_one() {
  std::string unit;
  put(unit, std::uint32_t{0});
  put(unit, std::uint32_t{1});
  put(unit, 1.0F);
  return unit;
}

}  // namespace

std::string yarns_text(const std::vector<YarnLine>& yarns) {
  constexpr std::uint32_t kColour = 0xff5a87c8;  // alpha, blue, green, red, from the highest byte down
  std::string points, infos;
  std::uint32_t n_points = 0;
  for (const YarnLine& yarn : yarns) {
    const Points corners = corners_of(yarn);
    for (const Eigen::Vector3d& corner : corners) {
      put_point(points, corner);
    }
    put(infos, n_points);
    n_points += static_cast<std::uint32_t>(corners.size());
    put(infos, n_points);
    put(infos, static_cast<float>(yarn.radius));
    put(infos, kColour);
  }
  std::string bytes;
  put_chunk(bytes, kPointsChunk, points);
  put_chunk(bytes, kSourceChunk, std::string(n_points * kSourceChunk.entry_bytes, '\0'));
  put_chunk(bytes, kYarnsChunk, infos);
  put_chunk(bytes, kStringsChunk, "1");
  put_chunk(bytes, kUnitsChunk, unit_of_one());
  put_chunk(bytes, kCheckpointsChunk, "");
  return bytes;
}

}  // namespace knitmech::curves
