#pragma once

#include <cmath>

#include "contact/closest_places.h"
#include "contact/constants.h"

namespace knitmech::contact {

/// How an overlap is counted: about its closest places, or by samples along the yarns.
///
/// Both integrate the same energy (line_potential.h). About the closest places the overlap must be short, for the
/// parabola to hold; samples need a long one, to see it at all. Which of them counts an overlap is decided when the
/// contact looks at the yarns anew, and stays until the next look: a share that followed the overlap in every step
/// would be a force without an energy, and heat the yarns up.

/// Half lengths of an overlap along both yarns [mm], by the parabola of the gap at its closest places.
struct HalfLengths {
  double first, second;
};

/// @pre the Hessian is positive definite
[[nodiscard]] inline HalfLengths half_lengths(const Followed& closest, double distance, const PairSize& size) {
  const Hessian& m = closest.hessian;
  const double least = kJudgedOverlap * size.radii;
  const double penetration = size.radii - distance > least ? size.radii - distance : least;
  const double scale = 2 * penetration * distance / m.determinant();
  return {size.first_length * std::sqrt(scale * m.tt), size.second_length * std::sqrt(scale * m.ss)};
}

/// Share of the overlap that samples of the first yarn stand for: one half where both yarns are sampled alike, 1 where
/// only this one is, because the other yarn's nearest places are not distinct: along the axis of a drum that this yarn
/// is wound on, for instance.
[[nodiscard]] inline double sample_share(const Followed& nearest, double distance, const PairSize& size) {
  const Hessian& m = nearest.hessian;
  const double slope = dot(nearest.at.between, nearest.at.first.slope) / distance;
  const double along = (m.ss - slope * slope) / (size.first_length * size.first_length);
  const double across = m.tt / (size.second_length * size.second_length);
  if (along <= 0) return 1;
  const double share = 1.5 - 2 * along / (along + across);  // from 1 at a quarter to 0 at three quarters
  return share < 0 ? 0 : (share < 1 ? share : 1);
}

}  // namespace knitmech::contact
