#pragma once

#include <vector>

#include "yarn_shape.h"

namespace knitmech::test {

/// Places at given lengths along a finely drawn line, with its directions as tangents. For shapes that are only a
/// start, such as a loosely tied knot. \param fine points much closer than the places wanted [mm]
/// \param lengths ascending [mm]
inline std::vector<Place> resample(const std::vector<Eigen::Vector3d>& fine, const std::vector<double>& lengths) {
  std::vector<Place> places;
  std::size_t behind = 1;
  Eigen::Vector3d step = fine[1] - fine[0];
  double start = 0;  // length at which the present step of the line starts
  for (const double length : lengths) {
    while (behind + 1 < fine.size() && start + step.norm() < length) {
      start += step.norm();
      ++behind;
      step = fine[behind] - fine[behind - 1];
    }
    const Eigen::Vector3d tangent = step.normalized();
    places.push_back({fine[behind - 1] + (length - start) * tangent, tangent});
  }
  return places;
}

/// Length of a finely drawn line [mm].
inline double length_of(const std::vector<Eigen::Vector3d>& fine) {
  double length = 0;
  for (std::size_t i = 1; i < fine.size(); ++i) length += (fine[i] - fine[i - 1]).norm();
  return length;
}

}  // namespace knitmech::test
