#pragma once

#include <Eigen/Core>

#include "knit/fabric.h"

namespace knitmech::knit {

/// The arc by which the yarn turns from one course into the next outside the side edge of a fabric, in the manner of
/// the ERC: flat, arc, straight leg, arc, flat. It lies in the plane of the feet, where both courses end, and goes from
/// the last foot of a course, along x, to the foot above it, against x:
///
///     flat l2,  quarter circle R,  leg T - 2 R along y,  quarter circle R,  flat l2,     R = min(R2, T / 2).
///
/// All stitches lie on the inner side of their edge feet, so the arc is clear of them whatever their shape, and of the
/// other arcs, which are a course spacing away.
struct TurningArc {
  double flat = 0;    ///< l2 [mm]
  double radius = 0;  ///< R [mm]
  double leg = 0;     ///< [mm]
  double length = 0;  ///< [mm], in all
};

[[nodiscard]] TurningArc make_turning_arc(const FabricLayout& layout);

/// A point of the arc in the axes of its start: x away from the fabric, y along the wale [mm], and its unit tangent.
struct ArcPoint {
  Eigen::Vector2d position;
  Eigen::Vector2d tangent;
};

/// The point at an arc length from the start [mm], 0 to arc.length.
[[nodiscard]] ArcPoint point_on(const TurningArc& arc, double arc_length);

/// Elements of a turning arc: as near to the length of those in the stitches as a whole number allows.
[[nodiscard]] int count_arc_elements(const TurningArc& arc, double erc_length, int elements_per_erc);

}  // namespace knitmech::knit
