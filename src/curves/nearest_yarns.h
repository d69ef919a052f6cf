#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace knitmech::curves {

/// A place on a yarn.
struct PlaceOnLine {
  std::size_t yarn = 0;
  double arc_length = 0;  ///< [mm], along the straight pieces from the yarn's first point
};

/// Where two pieces of yarn come closest.
struct NearestYarns {
  double distance = 0;  ///< [mm], of the centrelines
  PlaceOnLine a, b;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [mm], half way between
};

/// The closest places of yarns, each a chain of straight pieces between its points [mm]; empty if none are nearer than
/// the reach.
///
/// Two places of one yarn count only if the yarn between them is at least kComesBack times as long as they are apart,
/// and as the yarn is thick: the yarn has come back then, and does not merely go on. The search looks up pieces in
/// cells as large as reach and piece together, so the cost goes with the number of pieces.
/// @param diameter D of the yarns [mm] @param reach [mm]
[[nodiscard]] std::optional<NearestYarns> nearest_yarns(const std::vector<std::vector<Eigen::Vector3d>>& yarns,
                                                        double diameter, double reach);

}  // namespace knitmech::curves
