#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "curves/yarn_lines.h"

namespace knitmech::curves {

/// A cubic Bezier arc: its two ends, and the two corners that shape it.
struct CubicArc {
  std::array<Eigen::Vector3d, 4> corners;

  /// @param share of the parameter, in [0, 1]
  [[nodiscard]] Eigen::Vector3d point(double share) const;
  /// Derivative with respect to the share.
  [[nodiscard]] Eigen::Vector3d derivative(double share) const;
};

/// The centreline of an open yarn as a chain of cubic arcs, exactly the curve that its kind means.
///
/// through_points: the natural cubic spline over the lengths of the chords, twice differentiable, straight at its ends.
/// inner_points: the uniform Catmull-Rom spline; at a point its derivative is half the way from the point before to the
/// one after. midpoints: straight to the first middle of a chord, quadratic arcs from middle to middle, straight to the
/// end. Points that coincide with the one before are passed over but for inner_points.
///
/// @pre the yarn is open and has the points that check_lines() asks for
/// @throws InputError if all of its points coincide
[[nodiscard]] std::vector<CubicArc> smooth_line(const YarnLine& yarn, LineKind kind);

/// A chain of arcs by the length along it.
class AlongLine {
 public:
  struct Place {
    Eigen::Vector3d point;    ///< [length of the arcs]
    Eigen::Vector3d tangent;  ///< unit
  };

  explicit AlongLine(std::vector<CubicArc> arcs);

  [[nodiscard]] double length() const { return length_at_.back(); }
  /// @param arc_length from the beginning; what is outside [0, length()] is moved to its ends
  [[nodiscard]] Place at(double arc_length) const;

 private:
  std::vector<CubicArc> arcs_;
  std::vector<double> length_at_;  ///< at the ends of the pieces of all arcs, kPiecesPerArc to an arc
};

}  // namespace knitmech::curves
