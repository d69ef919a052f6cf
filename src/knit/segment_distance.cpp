#include "knit/segment_distance.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace knitmech::knit {
namespace {

using Eigen::Vector3d;

/// Parameter of the point of a segment nearest to a place; 0 for a segment of no length.
double nearest_parameter(const Vector3d& place, const Vector3d& start, const Vector3d& along) {
  const double length_squared = along.squaredNorm();
  return length_squared > 0 ? std::clamp((place - start).dot(along) / length_squared, 0.0, 1.0) : 0.0;
}

/// Parameter on a of the point nearest to the line of b, moved into the segment; 0 if the two are parallel.
double crossing_parameter(const Vector3d& along_a, const Vector3d& along_b, const Vector3d& from_b_to_a) {
  const double aa = along_a.squaredNorm();
  const double bb = along_b.squaredNorm();
  const double ab = along_a.dot(along_b);
  const double determinant = along_a.cross(along_b).squaredNorm();
  if (determinant <= 1e-24 * aa * bb) return 0;
  return std::clamp((ab * along_b.dot(from_b_to_a) - bb * along_a.dot(from_b_to_a)) / determinant, 0.0, 1.0);
}

}  // namespace

SegmentApproach closest_approach(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1) {
  const Vector3d along_a = a1 - a0;
  const Vector3d along_b = b1 - b0;
  // Two projections reach the least distance: the first is exact unless it was moved into b, and then the second is.
  double on_a = crossing_parameter(along_a, along_b, a0 - b0);
  const double on_b = nearest_parameter(a0 + on_a * along_a, b0, along_b);
  on_a = nearest_parameter(b0 + on_b * along_b, a0, along_a);
  return {((a0 + on_a * along_a) - (b0 + on_b * along_b)).norm(), on_a, on_b};
}

}  // namespace knitmech::knit
