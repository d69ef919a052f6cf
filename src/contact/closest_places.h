#pragma once

#include <cmath>

#include "contact/centreline.h"
#include "contact/constants.h"
#include "contact/line_potential.h"
#include "contact/yarn_elements.h"

namespace knitmech::contact {

/// Places on two yarns that are followed while the yarns move, with what is known about them there.
struct Followed {
  YarnPlace first{}, second{};  ///< shares may lie a small step beyond the element
  Places at{};
  Hessian hessian{};
  double slope_first =
      0;  ///< derivative of |between|^2 / 2 by the first share [mm^2]; not 0 where held at a yarn's end
  double slope_second = 0;  ///< by the second share
  bool is_minimum = false;  ///< found, and the distance grows in every free direction
};

/// Change of a place [share of an element] below which Newton's method need not look again: the error that is left is
/// about its square, and that of the distance the square of this.
inline constexpr double kFineStep = 1e-4;
inline constexpr double kLargestStep = 0.5;
inline constexpr int kMostSteps = 20;

/// Whether a place is pushed against an end of its yarn.
KNITMECH_INLINE bool is_held(const YarnElements& elements, YarnPlace place, double slope) {
  const auto element = static_cast<std::size_t>(place.element);
  return (place.share <= 0 && slope > 0 && !elements.has_previous(element)) ||
         (place.share >= 1 && slope < 0 && !elements.has_next(element));
}

/// A step of Newton's method that is not too long and does not lead off the yarn's end.
KNITMECH_INLINE double limited_step(const YarnElements& elements, YarnPlace place, double step) {
  const auto element = static_cast<std::size_t>(place.element);
  step = step > kLargestStep ? kLargestStep : (step < -kLargestStep ? -kLargestStep : step);
  if (place.share + step > 1 && !elements.has_next(element)) return 1 - place.share;
  if (place.share + step < 0 && !elements.has_previous(element)) return -place.share;
  return step;
}

KNITMECH_INLINE void set_slopes(Followed& here) {
  here.hessian = hessian(here.at);
  here.slope_first = -dot(here.at.between, here.at.first.slope);
  here.slope_second = dot(here.at.between, here.at.second.slope);
}

KNITMECH_INLINE void look(const YarnElements& elements, const Centreline& line, Followed& here) {
  here.first = walk(elements, here.first);
  here.second = walk(elements, here.second);
  const Curve a = line.curve(static_cast<std::size_t>(here.first.element));
  const Curve b = line.curve(static_cast<std::size_t>(here.second.element));
  here.at = places_at(point_at(a, here.first.share), point_at(b, here.second.share));
  set_slopes(here);
}

/// Moves both places by steps, with all that is known about them.
KNITMECH_INLINE void move(Followed& here, double ds, double dt) {
  here.first.share += ds;
  here.second.share += dt;
  here.at = places_at(shifted(here.at.first, ds), shifted(here.at.second, dt));
  set_slopes(here);
}

/// Follows the places where two yarns come closest, by Newton's method on |x_b(t) - x_a(s)|^2 / 2 from where they were
/// last; places walk from element to element and stop at the ends of the yarns. While the yarns move little, one look
/// is enough.
KNITMECH_INLINE Followed follow_closest(const YarnElements& elements, const Centreline& line, YarnPlace first,
                                        YarnPlace second) {
  Followed here{.first = first, .second = second};
  for (int i = 0; i < kMostSteps; ++i) {
    look(elements, line, here);
    const Hessian& m = here.hessian;
    const bool free_s = !is_held(elements, here.first, here.slope_first);
    const bool free_t = !is_held(elements, here.second, here.slope_second);
    const bool convex = (!free_s || m.ss > 0) && (!free_t || m.tt > 0) && (!free_s || !free_t || m.determinant() > 0);
    // Where the square of the distance is not convex, the step of the straight lines along the slopes is taken.
    const double ss = convex ? m.ss : dot(here.at.first.slope, here.at.first.slope);
    const double tt = convex ? m.tt : dot(here.at.second.slope, here.at.second.slope);
    double ds = free_s ? -here.slope_first / ss : 0;
    double dt = free_t ? -here.slope_second / tt : 0;
    if (free_s && free_t) {
      const double determinant = ss * tt - m.st * m.st;
      if (determinant > 1e-10 * ss * tt) {
        ds = (m.st * here.slope_second - tt * here.slope_first) / determinant;
        dt = (m.st * here.slope_first - ss * here.slope_second) / determinant;
      } else {  // parallel: each goes half the way
        ds *= 0.5;
        dt *= 0.5;
      }
    }
    ds = limited_step(elements, here.first, ds);
    dt = limited_step(elements, here.second, dt);
    if (std::abs(ds) < kFineStep && std::abs(dt) < kFineStep) {
      move(here, ds, dt);
      here.is_minimum = convex;
      return here;
    }
    here.first.share += ds;
    here.second.share += dt;
  }
  return here;
}

/// The same with the place on the first yarn given: follows the place on the second that is nearest to it.
KNITMECH_INLINE Followed follow_nearest(const YarnElements& elements, const Centreline& line, YarnPlace first,
                                        YarnPlace second) {
  Followed here{.first = first, .second = second};
  for (int i = 0; i < kMostSteps; ++i) {
    look(elements, line, here);
    const bool free_t = !is_held(elements, here.second, here.slope_second);
    const bool convex = !free_t || here.hessian.tt > 0;
    const double tt = convex && free_t ? here.hessian.tt : dot(here.at.second.slope, here.at.second.slope);
    const double dt = free_t ? limited_step(elements, here.second, -here.slope_second / tt) : 0;
    if (std::abs(dt) < kFineStep) {
      move(here, 0, dt);
      here.is_minimum = convex;
      return here;
    }
    here.second.share += dt;
  }
  return here;
}

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

}  // namespace knitmech::contact
