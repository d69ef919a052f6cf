#pragma once

#include <Eigen/Core>

namespace knitmech::knit {

/// Where two straight segments come closest to each other.
struct SegmentApproach {
  double distance = 0;     ///< [mm]
  double parameter_a = 0;  ///< place on the first segment, 0 at its start to 1 at its end [-]
  double parameter_b = 0;  ///< the same on the second
};

/// Least distance of the segments a0-a1 and b0-b1, exact to rounding. Segments of no length are points; of parallel
/// segments that run side by side one of the closest pairs is taken.
[[nodiscard]] SegmentApproach closest_approach(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                                               const Eigen::Vector3d& b0, const Eigen::Vector3d& b1);

}  // namespace knitmech::knit
