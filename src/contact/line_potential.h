#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/constants.h"
#include "contact/curve.h"
#include "contact/normal_law.h"

namespace knitmech::contact {

/// The normal contact of two smooth centrelines a and b: every short piece of one repels every short piece of the other
/// that is nearer than the sum of the radii D,
///
///     energy = k  integral over a  integral over b  e(D - |x_b(t) - x_a(s)|)  dS dT
///
/// with the normal law e (normal_law.h) and the lengths dS, dT along the stress-free yarns. The energy knows no
/// elements, no master and slave, and no closest point that may jump; yarns that cross and yarns that lie side by side
/// follow the same law. Only the overlaps are integrated. One that is small beside the yarns' bending, a crossing, has
/// the distance as a parabola across it, and the integral is known; long ones are in strips.h.
///
/// The forces are the exact derivatives of these integrals by the curves, with all that depends on slopes and bends,
/// so that no energy appears or vanishes.
///
/// Compare the line potentials for slender fibres of Grill, Wall and Meier 2020 (doi:10.1002/nme.6309).

/// Force and what is conjugate to the derivatives of a curve at a place: the work of a small change of the curve is
/// force . dx + slope . dx' + bend . dx''.
struct CurveLoad {
  Vector3 force;  ///< [N]
  Vector3 slope;  ///< [N], since x' is by the place s
  Vector3 bend;   ///< [N]
};

/// What one overlap does to both curves.
struct PairLoad {
  double load = 0;     ///< normal force: of the resultant, the part along the line between the places [N]
  double tangent = 0;  ///< its derivative by the penetration [N/mm]
  double energy = 0;   ///< [mJ]
  CurveLoad on_first{}, on_second{};
};

/// Two places on the two curves.
struct Places {
  CurvePoint first, second;
  Vector3 between;  ///< from the first to the second [mm]
};

KNITMECH_INLINE Places places_at(const CurvePoint& first, const CurvePoint& second) {
  return {first, second, second.position - first.position};
}

/// Derivatives of |between|^2 / 2 by the places s and t.
struct Hessian {
  double ss, st, tt;
  [[nodiscard]] KNITMECH_INLINE double determinant() const { return ss * tt - st * st; }
};

KNITMECH_INLINE Hessian hessian(const Places& at) {
  return {dot(at.first.slope, at.first.slope) - dot(at.between, at.first.bend), -dot(at.first.slope, at.second.slope),
          dot(at.second.slope, at.second.slope) + dot(at.between, at.second.bend)};
}

/// What two overlapping yarns are made of.
struct PairSize {
  double radii;          ///< D, the sum of the radii [mm]
  double density;        ///< k [N/mm^3]
  double first_length;   ///< stress-free length of the first curve [mm]
  double second_length;  ///< of the second
};

/// The overlap about the closest places of two curves, with the distance a parabola in both directions:
///
///     energy = 2 pi k  L_a L_b  distance / sqrt(det M)  integral of e,     load = 2 pi k L_a L_b distance / sqrt(det
///     M) e(d)
///
/// with M the Hessian. For two straight yarns that cross at an angle c, load = pi k D d^2 / sin c to first order.
/// @pre M is positive definite, the places are where both slopes of the distance vanish, 0 < penetration < D
template <typename Law = AnyOverlap>
KNITMECH_INLINE PairLoad crossing_load(const Places& closest, const Hessian& m, double distance, const PairSize& size) {
  const double penetration = size.radii - distance;
  const double inverse = 1 / m.determinant();
  const double scale =
      2 * std::numbers::pi * size.density * size.first_length * size.second_length * distance * std::sqrt(inverse);
  const Vector3 normal = (1 / distance) * closest.between;
  const double energy = scale * Law::integral(penetration, size.radii);
  const double pressed = scale * Law::energy(penetration, size.radii);
  const double h = 0.5 * energy * inverse;

  // Derivatives of the energy by between, x_a', x_a'', x_b', x_b''.
  const Vector3& between = closest.between;
  const CurvePoint& a = closest.first;
  const CurvePoint& b = closest.second;
  Vector3 by_between = (energy / distance - pressed) * normal + h * (m.tt * a.bend - m.ss * b.bend);
  Vector3 by_a_slope = (-2 * h) * (m.tt * a.slope + m.st * b.slope);
  const Vector3 by_a_bend = (h * m.tt) * between;
  Vector3 by_b_slope = (-2 * h) * (m.ss * b.slope + m.st * a.slope);
  const Vector3 by_b_bend = (-h * m.ss) * between;

  // The closest places move with the curves; what that does to the energy.
  const double by_s = dot(by_a_slope, a.bend) + dot(by_a_bend, a.jerk) - dot(by_between, a.slope);
  const double by_t = dot(by_b_slope, b.bend) + dot(by_b_bend, b.jerk) + dot(by_between, b.slope);
  const double move_s = inverse * (m.st * by_t - m.tt * by_s);
  const double move_t = inverse * (m.st * by_s - m.ss * by_t);
  by_between = by_between - move_s * a.slope + move_t * b.slope;
  by_a_slope = by_a_slope - move_s * between;
  by_b_slope = by_b_slope + move_t * between;

  return {-dot(by_between, normal),
          scale * normal_force(penetration, size.radii),
          energy,
          {by_between, -1.0 * by_a_slope, -1.0 * by_a_bend},
          {-1.0 * by_between, -1.0 * by_b_slope, -1.0 * by_b_bend}};
}

/// Density k of the contact energy, times D^2 / K, for which two straight yarns that cross at a right angle with the
/// penetration c D, c = kReferenceOverlap, press with K c D: c / (2 pi (1 - c) (-c - ln(1 - c))).
inline double density_factor() {
  constexpr double c = kReferenceOverlap;
  return c / (2 * std::numbers::pi * (1 - c) * normal_energy(c, 1));
}

}  // namespace knitmech::contact
