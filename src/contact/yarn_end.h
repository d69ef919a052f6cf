#pragma once

#include "contact/closest_places.h"
#include "contact/line_potential.h"

namespace knitmech::contact {

/// An overlap that an end of a yarn cuts short: its resultant, and the places where that acts.
struct CutLoad {
  YarnPlace first{}, second{};
  Vector3 normal{};    ///< unit vector, first to second
  double load = 0;     ///< [N]
  double tangent = 0;  ///< [N/mm]
  double energy = 0;   ///< [mJ]
};

/// Distances along the yarn from a place to its ends [mm].
struct ToEnds {
  double back, ahead;
};
KNITMECH_INLINE ToEnds to_ends(const YarnElements& elements, YarnPlace place) {
  const auto element = static_cast<std::size_t>(place.element);
  const double along = place.share * elements.length[element];
  return {elements.before[element] + along, elements.after[element] - along};
}

/// Distance along the yarn from a place to its nearer end [mm]; not above 0 at the end itself.
KNITMECH_INLINE double to_nearer_end(const YarnElements& elements, YarnPlace place) {
  const ToEnds ends = to_ends(elements, place);
  return ends.back < ends.ahead ? ends.back : ends.ahead;
}

/// Whether an end of its yarn is nearer to a place than the root of squared / scale [mm].
KNITMECH_INLINE bool end_is_within(const YarnElements& elements, YarnPlace place, double squared, double scale) {
  const double distance = to_nearer_end(elements, place);
  return distance <= 0 || squared > distance * distance * scale;
}

/// A crossing at an end of the first yarn: the strips across the second yarn (see sample_load()), integrated along the
/// first yarn as far as it goes.
[[nodiscard]] CutLoad crossing_at_end(const YarnElements& elements, const Centreline& line, const Followed& closest,
                                      const PairSize& size);

/// A sample of the first yarn at an end of the second: the normal law, integrated along the second as far as it goes.
/// \param weight length of the sample [mm], times its share
[[nodiscard]] CutLoad sample_at_end(const YarnElements& elements, const Centreline& line, const Followed& nearest,
                                    const PairSize& size, double weight);

/// The same places seen from the other yarn.
[[nodiscard]] inline Followed swapped(const Followed& here) {
  Followed other = here;
  other.first = here.second;
  other.second = here.first;
  other.at = {here.at.second, here.at.first, -1.0 * here.at.between};
  other.hessian = {here.hessian.tt, here.hessian.st, here.hessian.ss};
  other.slope_first = here.slope_second;
  other.slope_second = here.slope_first;
  return other;
}

}  // namespace knitmech::contact
