#include "model/yarn_curve.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace knitmech::model {
namespace {

using Eigen::Vector3d;

Vector3d turned(const Eigen::Vector4d& wxyz, const Vector3d& vector) {
  return Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]) * vector;
}

bool is_finite(const CurvePiece& piece) {
  return piece.start.allFinite() && piece.end.allFinite() && piece.start_tangent.allFinite() &&
         piece.end_tangent.allFinite();
}

/// \param tangent_at unit tangent at a node   \param broken elements, ascending
template <class TangentAt>
std::vector<CurvePiece> curves_through(const Model& model, const std::vector<Vector3d>& points,
                                       const TangentAt& tangent_at, const std::vector<int>& broken) {
  std::vector<CurvePiece> pieces;
  for (std::size_t yarn = 0; yarn < model.yarns.size(); ++yarn) {
    const ModelYarn& data = model.yarns[yarn];
    bool continues = false;
    for (int node = data.first_node; node + 1 < data.first_node + data.n_nodes; ++node) {
      const auto a = static_cast<std::size_t>(node);
      const std::size_t b = a + 1;
      const double length = model.arc_length[b] - model.arc_length[a];
      CurvePiece piece{.start = points[a],
                       .end = points[b],
                       .start_tangent = length * tangent_at(a),
                       .end_tangent = length * tangent_at(b),
                       .radius = 0.5 * model.section_of(a).diameter,
                       .node = node,
                       .yarn = static_cast<int>(yarn),
                       .continues_piece_before = continues};
      continues = is_finite(piece) && !std::ranges::binary_search(broken, node);
      if (continues) {
        pieces.push_back(std::move(piece));
      }
    }
  }
  return pieces;
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

Vector3d CurvePiece::second_derivative(double u) const {
  return (6 - 12 * u) * (end - start) + (6 * u - 4) * start_tangent + (6 * u - 2) * end_tangent;
}

std::vector<CurvePiece> yarn_curves(const Model& model) {
  const auto tangent = [&](std::size_t node) { return model.tangents[node]; };
  return curves_through(model, model.nodes, tangent, {});
}

std::vector<CurvePiece> yarn_curves(const Model& model, const Frame& frame) {
  const auto tangent = [&](std::size_t node) { return turned(frame.rotations[node], model.tangents[node]); };
  return curves_through(model, frame.points, tangent, frame.broken);
}

}  // namespace knitmech::model
