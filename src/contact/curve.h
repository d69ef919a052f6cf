#pragma once

#include "base/vector3.h"

namespace knitmech::contact {

/// One element's piece of the smooth centreline: the cubic Hermite curve through its two nodes with the nodes'
/// tangents, and what takes it through a third point amid them,
///
///     x(s) = H1(s) a + H2(s) a' + H3(s) b + H4(s) b' + 16 s^2 (1 - s)^2 c,   0 <= s <= 1,
///
/// a' and b' the nodes' unit tangents times the stress-free arc length of the element, and c the bow: how far the
/// middle of the true yarn lies off the cubic. Neighbouring pieces join with the same tangent.
///
/// The cubic alone leaves a loop where a straight piece joins an arc amid an element: by up to k L^2 / 62, k the
/// arc's curvature and L the element's length, which at N10 is a tenth of the yarn diameter, and just where the heads
/// and feet of two courses meet.
struct Curve {
  Vector3 start{}, end{};              ///< a, b [mm]
  Vector3 start_slope{}, end_slope{};  ///< a', b' [mm]
  Vector3 bow{};                       ///< c [mm]
};

/// Values of the four Hermite functions and the bow's, or of their derivatives.
struct HermiteWeights {
  double start, start_slope, end, end_slope, bow;
};

KNITMECH_INLINE HermiteWeights hermite(double s) {
  const double r = 1 - s;
  return {r * r * (1 + 2 * s), s * r * r, s * s * (3 - 2 * s), -s * s * r, 16 * s * s * r * r};
}

/// First derivatives by s.
KNITMECH_INLINE HermiteWeights hermite_slope(double s) {
  const double bell = 6 * s * (1 - s);
  return {-bell, (1 - s) * (1 - 3 * s), bell, s * (3 * s - 2), 32 * s * (1 - s) * (1 - 2 * s)};
}

/// Second derivatives by s.
KNITMECH_INLINE HermiteWeights hermite_bend(double s) {
  return {12 * s - 6, 6 * s - 4, 6 - 12 * s, 6 * s - 2, 32 - 192 * s * (1 - s)};
}

KNITMECH_INLINE Vector3 combine(const Curve& curve, HermiteWeights weights) {
  return weights.start * curve.start + weights.start_slope * curve.start_slope + weights.end * curve.end +
         weights.end_slope * curve.end_slope + weights.bow * curve.bow;
}

/// A place on a curve with the derivatives there by s.
struct CurvePoint {
  Vector3 position;           ///< x [mm]
  Vector3 slope, bend, jerk;  ///< first, second and third derivative [mm]
  Vector3 fourth;             ///< fourth derivative [mm]; the same along the whole curve
};

/// A place on a curve; s may lie a little beyond its ends.
KNITMECH_INLINE CurvePoint point_at(const Curve& curve, double s) {
  const Vector3 chord = curve.end - curve.start;
  const Vector3 c4 = 16.0 * curve.bow;
  const Vector3 c2 = 3.0 * chord - 2.0 * curve.start_slope - curve.end_slope + c4;
  const Vector3 c3 = curve.start_slope + curve.end_slope - 2.0 * chord - 2.0 * c4;
  return {curve.start + s * (curve.start_slope + s * (c2 + s * (c3 + s * c4))),
          curve.start_slope + s * (2.0 * c2 + s * (3.0 * c3 + (4 * s) * c4)), 2.0 * c2 + s * (6.0 * c3 + (12 * s) * c4),
          6.0 * c3 + (24 * s) * c4, 24.0 * c4};
}

/// The same some way on; exact, since the curve is of the fourth degree.
KNITMECH_INLINE CurvePoint shifted(const CurvePoint& at, double step) {
  const Vector3 jerk = at.jerk + (step / 4) * at.fourth;
  const Vector3 bend = at.bend + (step / 3) * jerk;
  return {at.position + step * (at.slope + (step / 2) * bend),
          at.slope + step * (at.bend + (step / 2) * (at.jerk + (step / 3) * at.fourth)),
          at.bend + step * (at.jerk + (step / 2) * at.fourth), at.jerk + step * at.fourth, at.fourth};
}

/// How far the curve may leave the straight line between its ends at most [mm]: with d and e the differences of the two
/// slopes from that line, |H2 d + H4 e| <= (H2 - H4) max(|d|, |e|) = s (1 - s) max(|d|, |e|); and the bow.
KNITMECH_INLINE double bulge(const Curve& curve) {
  const Vector3 chord = curve.end - curve.start;
  const Vector3 d = curve.start_slope - chord;
  const Vector3 e = curve.end_slope - chord;
  const double d2 = dot(d, d);
  const double e2 = dot(e, e);
  return 0.25 * std::sqrt(d2 > e2 ? d2 : e2) + length(curve.bow);
}

/// The part of a curve between two places on it; the same line: its fourth derivative stays, and 16 c is a 24th of it.
KNITMECH_INLINE Curve part_of(const Curve& curve, double from, double to) {
  const CurvePoint a = point_at(curve, from);
  const CurvePoint b = point_at(curve, to);
  const double share = to - from;
  return {a.position, b.position, share * a.slope, share * b.slope, (share * share * share * share) * curve.bow};
}

}  // namespace knitmech::contact
