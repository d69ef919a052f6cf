#include "picture/yarn_curve.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace knitmech::picture {
namespace {

using Eigen::Vector3d;

Vector3d turned(const Eigen::Vector4d& wxyz, const Vector3d& vector) {
  return Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]) * vector;
}

bool is_finite(const CurvePiece& piece) {
  return piece.start.allFinite() && piece.end.allFinite() && piece.start_tangent.allFinite() &&
         piece.end_tangent.allFinite();
}

}  // namespace

Vector3d CurvePiece::point(double u) const {
  const double v = 1 - u;
  return (v * v * (1 + 2 * u)) * start + (u * u * (1 + 2 * v)) * end + (u * v * v) * start_tangent -
         (u * u * v) * end_tangent;
}

Vector3d CurvePiece::tangent(double u) const {
  const double v = 1 - u;
  const Vector3d derivative =
      (6 * u * v) * (end - start) + (v * (v - 2 * u)) * start_tangent + (u * (u - 2 * v)) * end_tangent;
  const double length = derivative.norm();
  return length > 0 ? Vector3d(derivative / length) : Vector3d::UnitX();
}

std::vector<CurvePiece> yarn_curves(const model::Model& model, const model::Frame& frame) {
  std::vector<CurvePiece> pieces;
  for (std::size_t yarn = 0; yarn < model.yarns.size(); ++yarn) {
    const model::ModelYarn& data = model.yarns[yarn];
    bool continues = false;
    for (int node = data.first_node; node + 1 < data.first_node + data.n_nodes; ++node) {
      const auto a = static_cast<std::size_t>(node);
      const std::size_t b = a + 1;
      const double length = model.arc_length[b] - model.arc_length[a];
      CurvePiece piece{.start = frame.points[a],
                       .end = frame.points[b],
                       .start_tangent = length * turned(frame.rotations[a], model.tangents[a]),
                       .end_tangent = length * turned(frame.rotations[b], model.tangents[b]),
                       .radius = 0.5 * model.section_of(a).diameter,
                       .node = node,
                       .yarn = static_cast<int>(yarn),
                       .continues_piece_before = continues};
      continues = is_finite(piece) && !std::ranges::binary_search(frame.broken, node);
      if (continues) {
        pieces.push_back(std::move(piece));
      }
    }
  }
  return pieces;
}

}  // namespace knitmech::picture
