#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "exchange/yarn_samples.h"

namespace knitmech::exchange {

/// What is drawn as tubes.
struct YarnTubes {
  std::string title;                      ///< of the fabric
  std::vector<model::CurvePiece> pieces;  ///< model::yarn_curves()
  int sides = 12;                         ///< of the polygon that stands for the circle, at least 3
};

/// A corner of a triangle: indices into TubeMesh::points and TubeMesh::normals.
struct TubeCorner {
  std::uint32_t point = 0, normal = 0;
};

/// A closed tube of triangles about a row of elements, in single precision, as files store it.
///
/// Its rings have `sides` points on the yarn's surface, in planes across the smooth centreline: the volume is that of
/// the polygon within the circle, n / 2 sin(2 pi / n) r^2 times the length. From ring to ring the points turn as little
/// as they can (rotation-minimising frame), so that the edges run along the tube. The two ends are flat. Every edge
/// belongs to two triangles, which run through it in opposite directions; corners go counterclockwise, seen from
/// outside.
struct TubeMesh {
  int yarn = 0;                                      ///< index into model::Model::yarns
  std::uint32_t sides = 0;                           ///< points of a ring
  std::vector<Eigen::Vector3f> points;               ///< [mm], ring by ring
  std::vector<Eigen::Vector3f> normals;              ///< outward, unit: of each point, then of the first and last end
  std::vector<std::array<TubeCorner, 3>> triangles;  ///< of the wall, then of the first and of the last end
};

/// The rows of elements that are one tube each: yarns, cut where they have broken and where their radius changes.
[[nodiscard]] std::vector<YarnRow> tube_rows(const std::vector<model::CurvePiece>& pieces);

/// The tube about one of those rows.
[[nodiscard]] TubeMesh tube_mesh(YarnRow row, int sides);

/// How large a tube is.
struct TubeSize {
  std::uint64_t points = 0, triangles = 0;
};

/// The size of tube_mesh(row, sides), without making it.
[[nodiscard]] TubeSize tube_size(YarnRow row, int sides);

/// Throws InputError that names the size if a file is larger than kMostFileBytes.
void check_file_size(std::uint64_t bytes);

}  // namespace knitmech::exchange
