#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace knitmech::contact {

/// The gap of one yarn to another about a place, along the yarn: g(x) = -depth + slope x + curvature x^2 / 2, for x
/// between its ends.
struct GapParabola {
  double depth;      ///< [mm], penetration at x = 0, > 0
  double slope;      ///< [-]
  double curvature;  ///< [1/mm], > 0
  double low, high;  ///< [mm], where the yarn ends; low <= 0 <= high
};

/// What a law gives at one place.
struct LawValues {
  double force, tangent, energy;
};

/// A law integrated along the overlap of a parabola with a yarn that ends within it.
struct CutOverlap {
  LawValues sum{};
  double centre = 0;  ///< [mm], where the resultant acts
};

/// Integrates law(depth) along x where the gap is negative and the yarn is, by five Gauss points.
template <typename Law>
CutOverlap integrate_cut(const GapParabola& gap, const Law& law) {
  constexpr std::array<double, 5> kNodes = {-0.906179845938664, -0.538469310105683, 0, 0.538469310105683,
                                            0.906179845938664};
  constexpr std::array<double, 5> kWeights = {0.236926885056189, 0.478628670499366, 0.568888888888889,
                                              0.478628670499366, 0.236926885056189};
  const double root = std::sqrt(gap.slope * gap.slope + 2 * gap.curvature * gap.depth);
  const double from = std::max(gap.low, (-gap.slope - root) / gap.curvature);
  const double to = std::min(gap.high, (-gap.slope + root) / gap.curvature);
  const double half = 0.5 * (to - from);
  const double middle = 0.5 * (to + from);
  CutOverlap overlap;
  double moment = 0;
  for (std::size_t k = 0; k < kNodes.size(); ++k) {
    const double x = middle + kNodes[k] * half;
    const double depth = gap.depth - x * (gap.slope + 0.5 * gap.curvature * x);
    if (depth <= 0) continue;  // rounding, at the ends of a vanishing overlap
    const LawValues here = law(depth);
    const double weight = kWeights[k] * half;
    overlap.sum.force += weight * here.force;
    overlap.sum.tangent += weight * here.tangent;
    overlap.sum.energy += weight * here.energy;
    moment += weight * here.force * x;
  }
  if (overlap.sum.force > 0) overlap.centre = moment / overlap.sum.force;
  return overlap;
}

}  // namespace knitmech::contact
