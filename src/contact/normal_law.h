#pragma once

#include <cmath>

#include "base/vectorise.h"

namespace knitmech::contact {

/// The "hard" normal law: no force across a gap, and one that grows without bound before two centrelines meet.
///
/// With penetration d and sum of the radii D (0 < d < D), for a stiffness of one:
///
///     force    f(d) = d D / (D - d)
///     tangent  D^2 / (D - d)^2
///     energy   e(d) = D (-d - D ln(1 - d / D))  =  d^2 / 2 + d^3 / (3 D) + ...
///
/// A penalty of bounded force would let a yarn be pulled through another; this one cannot at any load. On chords it is
/// the law of a contact point; on the smooth centreline that of every pair of short pieces (line_potential.h), and what
/// is below are its integrals over the overlap of two yarns.

/// d / D below which the series are exact to rounding.
inline constexpr double kSmallOverlap = 0.02;

/// Force f [mm].
KNITMECH_INLINE double normal_force(double penetration, double radii) {
  return penetration * radii / (radii - penetration);
}

/// Tangent [-].
KNITMECH_INLINE double normal_tangent(double penetration, double radii) {
  const double growth = radii / (radii - penetration);
  return growth * growth;
}

/// Energy e [mm^2] by its series D^2 (x^2 / 2 + x^3 / 3 + ...), x = d / D, exact to rounding for small overlaps.
KNITMECH_INLINE double small_normal_energy(double penetration, double radii) {
  const double x = penetration / radii;
  return radii * radii * x * x * (1.0 / 2 + x * (1.0 / 3 + x * (1.0 / 4 + x * (1.0 / 5 + x * (1.0 / 6 + x / 7)))));
}

/// Energy e [mm^2].
KNITMECH_INLINE double normal_energy(double penetration, double radii) {
  const double x = penetration / radii;
  return x > kSmallOverlap ? radii * radii * (-x - std::log1p(-x)) : small_normal_energy(penetration, radii);
}

/// Integral of the energy over the penetration [mm^3] by its series D^3 (x^3 / 6 + x^4 / 12 + ...), for small overlaps.
KNITMECH_INLINE double small_integral_of_energy(double penetration, double radii) {
  const double x = penetration / radii;
  return radii * radii * radii * x * x * x *
         (1.0 / 6 + x * (1.0 / 12 + x * (1.0 / 20 + x * (1.0 / 30 + x * (1.0 / 42 + x * (1.0 / 56))))));
}

/// Integral of the energy over the penetration [mm^3]: D^3 (x - x^2 / 2 + (1 - x) ln(1 - x)).
KNITMECH_INLINE double integral_of_energy(double penetration, double radii) {
  const double x = penetration / radii;
  if (x <= kSmallOverlap) return small_integral_of_energy(penetration, radii);
  return radii * radii * radii * (x - 0.5 * x * x + (1 - x) * std::log1p(-x));
}

/// The laws for any overlap, and for small ones: without branches, for contacts that are evaluated side by side.
struct AnyOverlap {
  static KNITMECH_INLINE double energy(double d, double radii) { return normal_energy(d, radii); }
  static KNITMECH_INLINE double integral(double d, double radii) { return integral_of_energy(d, radii); }
};
struct SmallOverlap {
  static KNITMECH_INLINE double energy(double d, double radii) { return small_normal_energy(d, radii); }
  static KNITMECH_INLINE double integral(double d, double radii) { return small_integral_of_energy(d, radii); }
};

}  // namespace knitmech::contact
