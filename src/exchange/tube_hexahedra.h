#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "exchange/yarn_path.h"

namespace knitmech::exchange {

/// Nodes of the section at the end of an element and at its middle.
inline constexpr int kSectionNodes = 20, kMiddleNodes = 8;
/// Hexahedra across the section: an inner one and four around it.
inline constexpr int kSectionQuads = 5;

/// A yarn as 20-node hexahedra, swept along its path: across the section an inner square and four around it, whose
/// outer sides are quarters of the circle.
///
/// The outline is four parabolas through eight points of a circle, wider by 0.6 % of the radius than the yarn, so that
/// the area is that of the yarn's circle: EA is exact. With the inner square at kCoreShare the 2 x 2 points of reduced
/// integration give the second moment of area of the circle to 0.02 %. From end to end the section turns as little as
/// it can.
struct TubeHexahedra {
  int yarn = 0;                               ///< index into model::Model::yarns
  std::vector<Eigen::Vector3d> nodes;         ///< [mm]
  std::vector<std::array<int, 20>> elements;  ///< nodes in the order of C3D20; five an element of the path, inner first
  /// Nodes at each point of the path: kSectionNodes at ends, kMiddleNodes at middles. The first four, at the corners of
  /// the inner square, have the centreline in their middle.
  std::vector<std::vector<int>> rings;
};

[[nodiscard]] TubeHexahedra tube_hexahedra(const YarnPath& path, double radius);

/// The face of the hexahedra around the inner one that lies on the yarn's surface: nodes 2, 6, 7 and 3.
inline constexpr int kOuterFace = 4;

}  // namespace knitmech::exchange
