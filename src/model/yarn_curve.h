#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::model {

/// The smooth centreline of one element: a cubic Hermite curve between its two nodes.
struct CurvePiece {
  Eigen::Vector3d start, end;                  ///< [mm]
  Eigen::Vector3d start_tangent, end_tangent;  ///< derivative with respect to the parameter [mm]
  double radius = 0;                           ///< of the yarn [mm]
  int node = 0;                                ///< first node of the element
  int yarn = 0;                                ///< index into Model::yarns
  bool continues_piece_before = false;         ///< starts where the piece before ended

  /// Point at the parameter u in 0 to 1 [mm].
  [[nodiscard]] Eigen::Vector3d point(double u) const;
  /// Unit tangent at the parameter u.
  [[nodiscard]] Eigen::Vector3d tangent(double u) const;
  /// Second derivative with respect to the parameter [mm]; it is linear in u.
  [[nodiscard]] Eigen::Vector3d second_derivative(double u) const;
};

/// The centrelines of a frame, element by element. The tangents are those of the true loop curve at the start, turned
/// with their nodes, and as long as the element's rest arc length, so the yarn looks smooth on a coarse mesh.
///
/// Elements that have broken, or have a position or rotation that is not a finite number, are left out.
[[nodiscard]] std::vector<CurvePiece> yarn_curves(const Model& model, const Frame& frame);

/// The same of the fabric as it was knitted.
[[nodiscard]] std::vector<CurvePiece> yarn_curves(const Model& model);

}  // namespace knitmech::model
