#pragma once

#include "base/vector3.h"

namespace knitmech::contact {

/// One element's piece of the smooth centreline: the cubic Hermite curve through its two nodes with the nodes'
/// tangents,
///
///     x(s) = H1(s) a + H2(s) a' + H3(s) b + H4(s) b',   0 <= s <= 1,
///
/// a' and b' the nodes' unit tangents times the stress-free arc length of the element. Neighbouring pieces join with
/// the same tangent.
struct Curve {
  Vector3 start, end;              ///< a, b [mm]
  Vector3 start_slope, end_slope;  ///< a', b' [mm]
};

/// Values of the four Hermite functions, or of their derivatives.
struct HermiteWeights {
  double start, start_slope, end, end_slope;
};

KNITMECH_INLINE HermiteWeights hermite(double s) {
  const double r = 1 - s;
  return {r * r * (1 + 2 * s), s * r * r, s * s * (3 - 2 * s), -s * s * r};
}

/// First derivatives by s.
KNITMECH_INLINE HermiteWeights hermite_slope(double s) {
  const double bell = 6 * s * (1 - s);
  return {-bell, (1 - s) * (1 - 3 * s), bell, s * (3 * s - 2)};
}

/// Second derivatives by s.
KNITMECH_INLINE HermiteWeights hermite_bend(double s) {
  return {12 * s - 6, 6 * s - 4, 6 - 12 * s, 6 * s - 2};
}

KNITMECH_INLINE Vector3 combine(const Curve& curve, HermiteWeights weights) {
  return weights.start * curve.start + weights.start_slope * curve.start_slope + weights.end * curve.end +
         weights.end_slope * curve.end_slope;
}

/// How far the curve may leave the straight line between its ends at most [mm]: with d and e the differences of the two
/// slopes from that line, |H2 d + H4 e| <= (H2 - H4) max(|d|, |e|) = s (1 - s) max(|d|, |e|).
KNITMECH_INLINE double bulge(const Curve& curve) {
  const Vector3 chord = curve.end - curve.start;
  const Vector3 d = curve.start_slope - chord;
  const Vector3 e = curve.end_slope - chord;
  const double d2 = dot(d, d);
  const double e2 = dot(e, e);
  return 0.25 * std::sqrt(d2 > e2 ? d2 : e2);
}

}  // namespace knitmech::contact
