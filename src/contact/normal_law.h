#pragma once

#include <cmath>

namespace knitmech::contact {

/// The "hard" normal law: no force across a gap, and one that grows without bound before two centrelines meet.
///
/// With penetration d and sum of the radii D (0 < d < D), for a stiffness K:
///
///     force    K d D / (D - d)
///     tangent  K D^2 / (D - d)^2
///     energy   K D (-d - D ln(1 - d / D))  =  K d^2 / 2 + K d^3 / (3 D) + ...
///
/// A penalty of bounded force would let a yarn be pulled through another; this one cannot at any load.

/// Force per stiffness [mm].
inline double normal_force(double penetration, double radii) {
  return penetration * radii / (radii - penetration);
}

/// Tangent per stiffness [-].
inline double normal_tangent(double penetration, double radii) {
  const double growth = radii / (radii - penetration);
  return growth * growth;
}

/// Energy per stiffness [mm^2]; by its series D^2 (x^2 / 2 + x^3 / 3 + ...), x = d / D, where few terms of it are
/// exact.
inline double normal_energy(double penetration, double radii) {
  const double x = penetration / radii;
  if (x > 0.02) return radii * radii * (-x - std::log1p(-x));
  return radii * radii * x * x * (1.0 / 2 + x * (1.0 / 3 + x * (1.0 / 4 + x * (1.0 / 5 + x * (1.0 / 6 + x / 7)))));
}

}  // namespace knitmech::contact
