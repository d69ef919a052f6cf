#pragma once

#include <algorithm>
#include <cmath>

#include "contact/normal_law.h"

namespace knitmech::contact {

/// The gap of one yarn to another about a place, along the yarn: g(x) = -depth + slope x + curvature x^2 / 2, for x
/// between the ends of the element.
struct GapParabola {
  double depth;      ///< [mm], penetration at x = 0, > 0
  double slope;      ///< [-]
  double curvature;  ///< [1/mm], > 0
  double low, high;  ///< [mm], low <= 0 <= high
};

/// Resultant of the normal law over the overlap of a parabola, per line stiffness.
struct Overlap {
  double load = 0;         ///< integral of the force [mm^2]
  double tangent = 0;      ///< integral of its tangent [mm]
  double energy = 0;       ///< integral of the energy [mm^3]
  double centre = 0;       ///< [mm], where the resultant acts
  double half_length = 0;  ///< [mm], of the overlap
};

/// Integrates the normal law where the gap is negative, by three Gauss points: exact for the linear penalty, whose
/// energy is a polynomial of fourth degree there.
inline Overlap integrate(const GapParabola& gap, double radii) {
  constexpr double kNode = 0.774596669241483377;  // sqrt(3 / 5)
  const double root = std::sqrt(gap.slope * gap.slope + 2 * gap.curvature * gap.depth);
  const double from = std::max(gap.low, (-gap.slope - root) / gap.curvature);
  const double to = std::min(gap.high, (-gap.slope + root) / gap.curvature);
  const double half = 0.5 * (to - from);
  const double middle = 0.5 * (to + from);
  Overlap overlap;
  overlap.half_length = half;
  double moment = 0;
  for (const double node : {-kNode, 0.0, kNode}) {
    const double weight = (node == 0.0 ? 8.0 / 9 : 5.0 / 9) * half;
    const double x = middle + node * half;
    const double depth = gap.depth - x * (gap.slope + 0.5 * gap.curvature * x);
    if (depth <= 0) continue;  // rounding, at the ends of a vanishing overlap
    const double load = weight * normal_force(depth, radii);
    overlap.load += load;
    overlap.tangent += weight * normal_tangent(depth, radii);
    overlap.energy += weight * normal_energy(depth, radii);
    moment += load * x;
  }
  if (overlap.load > 0) overlap.centre = moment / overlap.load;
  return overlap;
}

}  // namespace knitmech::contact
