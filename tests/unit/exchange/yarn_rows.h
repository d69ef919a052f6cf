#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/yarn_curve.h"

namespace knitmech::exchange {

/// A straight yarn of radius 0.1 mm from the origin along (1, 2, 2) / 3, 6 mm long, of three elements.
inline std::vector<model::CurvePiece> straight_pieces() {
  const Eigen::Vector3d direction = Eigen::Vector3d(1, 2, 2) / 3;
  std::vector<model::CurvePiece> pieces(3);
  for (int i = 0; i < 3; ++i) {
    model::CurvePiece& piece = pieces[static_cast<std::size_t>(i)];
    piece.start = 2.0 * i * direction;
    piece.end = 2.0 * (i + 1) * direction;
    piece.start_tangent = piece.end_tangent = 2 * direction;
    piece.radius = 0.1;
    piece.node = i;
    piece.continues_piece_before = i > 0;
  }
  return pieces;
}

/// Cubic pieces on a helix about z: (R cos a, R sin a, climb a), which meets the helix at its nodes and is within a few
/// millionths of R of it between.
inline std::vector<model::CurvePiece> helix_pieces(double bend_radius, double climb, double turns, double radius,
                                                   int per_turn = 24) {
  const double step = 2 * std::numbers::pi / per_turn;
  const auto point = [&](double a) -> Eigen::Vector3d {
    return {bend_radius * std::cos(a), bend_radius * std::sin(a), climb * a};
  };
  const auto tangent = [&](double a) -> Eigen::Vector3d {
    return {-bend_radius * std::sin(a), bend_radius * std::cos(a), climb};
  };
  std::vector<model::CurvePiece> pieces;
  for (int i = 0; i < std::lround(turns * per_turn); ++i) {
    model::CurvePiece& piece = pieces.emplace_back();
    piece.start = point(i * step);
    piece.end = point((i + 1) * step);
    piece.start_tangent = step * tangent(i * step);
    piece.end_tangent = step * tangent((i + 1) * step);
    piece.radius = radius;
    piece.node = i;
    piece.continues_piece_before = i > 0;
  }
  return pieces;
}

}  // namespace knitmech::exchange
