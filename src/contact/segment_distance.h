#pragma once

#include <algorithm>

#include "base/vector3.h"

namespace knitmech::contact {

/// Where two straight segments come closest: shares of the way from start to end, both in [0, 1].
struct ClosestPoints {
  double s, t;
};

/// Share of the way along a segment, in [0, 1], at which it comes closest to a point.
/// \param start, along start of the segment and vector to its end [mm], not zero
inline double closest_on_segment(Vector3 point, Vector3 start, Vector3 along) {
  return std::clamp(dot(point - start, along) / dot(along, along), 0.0, 1.0);
}

/// Closest points of the segments a + s u and b + t v.
///
/// The squared distance is convex in (s, t): the minimum of the infinite lines is clamped in s, t follows, and is
/// clamped in turn with s once more (Lumelsky 1985; Ericson, Real-Time Collision Detection, 5.1.9). Parallel segments
/// have a whole range of closest points; then s is the one nearest to the middle of their overlap, so that no end is
/// preferred.
inline ClosestPoints closest_points(Vector3 a, Vector3 u, Vector3 b, Vector3 v) {
  constexpr double kParallel = 1e-12;  // squared sine of the angle below which the segments count as parallel
  const Vector3 r = a - b;
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uv = dot(u, v);
  const double ur = dot(u, r);
  const double vr = dot(v, r);
  const double determinant = uu * vv - uv * uv;

  double s = 0;
  if (determinant > kParallel * uu * vv) {
    s = std::clamp((uv * vr - ur * vv) / determinant, 0.0, 1.0);
  } else {
    const double start = std::clamp(-ur / uu, 0.0, 1.0);
    const double end = std::clamp((uv - ur) / uu, 0.0, 1.0);
    s = 0.5 * (start + end);
  }
  double t = (uv * s + vr) / vv;
  if (t < 0) {
    t = 0;
    s = std::clamp(-ur / uu, 0.0, 1.0);
  } else if (t > 1) {
    t = 1;
    s = std::clamp((uv - ur) / uu, 0.0, 1.0);
  }
  return {s, t};
}

}  // namespace knitmech::contact
