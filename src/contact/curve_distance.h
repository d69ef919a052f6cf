#pragma once

#include "contact/curve.h"

namespace knitmech::contact {

/// Where two curve pieces come closest, each place held within its piece.
struct CurveApproach {
  double s, t;      ///< places on the first and second piece, in [0, 1]
  Vector3 between;  ///< from the first to the second [mm]
  double slope_s,
      slope_t;  ///< derivatives of |between|^2 / 2 by s and t [mm^2]; not zero where a place is held at an end
  Vector3 first_slope, first_bend;    ///< derivatives of the first curve by s [mm]
  Vector3 second_slope, second_bend;  ///< of the second by t [mm]
  bool is_minimum;                    ///< found, and the distance grows in every free direction
};

/// Local minimum of the distance from a start, by Newton's method on |x_b(t) - x_a(s)|^2 / 2 in the unit square: a
/// place that is pushed against its end is held there. Where the square of the distance is not convex, the step of the
/// linearised curves is taken instead.
[[nodiscard]] CurveApproach closest_on_curves(const Curve& first, const Curve& second, double s, double t);

}  // namespace knitmech::contact
