#pragma once

#include <algorithm>

#include "base/vector3.h"

namespace knitmech {

/// Where two straight segments come closest: shares of the way from start to end, both in [0, 1].
struct ClosestPoints {
  double s, t;
};

/// Share of the way along a segment, in [0, 1], at which it comes closest to a point; 0 for a segment of no length.
/// \param start, along start of the segment and vector to its end [mm]
inline double closest_on_segment(Vector3 point, Vector3 start, Vector3 along) {
  const double squared = dot(along, along);
  return squared > 0 ? std::clamp(dot(point - start, along) / squared, 0.0, 1.0) : 0.0;
}

/// Closest points of the segments a + s u and b + t v [mm], exact to rounding.
///
/// The squared distance is convex in (s, t): the s of the infinite lines, -((a - b) x v) . n / n . n with n = u x v, is
/// clamped, t follows, and where t has to be clamped s follows it (Lumelsky 1985; Ericson, Real-Time Collision
/// Detection, 5.1.9). n . n is the determinant |u|^2 |v|^2 - (u . v)^2 of the two equations without its cancellation,
/// so segments that are nearly parallel lose no digits. Parallel segments have a whole range of closest points; then s
/// is the one in the middle of their overlap, so that no end is preferred. A segment of no length is a point.
inline ClosestPoints closest_points(Vector3 a, Vector3 u, Vector3 b, Vector3 v) {
  // Squared sine of the angle below which segments count as parallel: between elements of a fabric a thousand times
  // their length, smaller angles are the rounding of their positions. Larger values make s less exact.
  constexpr double kParallel = 1e-20;
  const Vector3 normal = cross(u, v);
  const double determinant = dot(normal, normal);
  const double vv = dot(v, v);

  double s = 0;
  if (determinant > kParallel * dot(u, u) * vv) {
    s = std::clamp(dot(cross(b - a, v), normal) / determinant, 0.0, 1.0);
  } else {
    s = 0.5 * (closest_on_segment(b, a, u) + closest_on_segment(b + v, a, u));
  }
  const double along_v = dot(a + s * u - b, v);
  if (along_v < 0) return {closest_on_segment(b, a, u), 0};
  if (along_v > vv) return {closest_on_segment(b + v, a, u), 1};
  return {s, vv > 0 ? along_v / vv : 0};
}

}  // namespace knitmech
