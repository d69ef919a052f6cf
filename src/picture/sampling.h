#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace knitmech::picture {

/// A short stream of evenly spread random numbers that depends on its seed alone, so that a picture is the same in
/// every run and with any number of threads (the mixing function is Stafford's variant 13, as in SplitMix64).
class Randomness {
 public:
  explicit Randomness(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 1) {}

  /// The next number in [0, 1).
  double next() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBULL;
    mixed ^= mixed >> 31U;
    return static_cast<double>(mixed >> 11U) * 0x1.0p-53;
  }

 private:
  std::uint64_t state_;
};

/// A unit vector in a disc about a direction: towards a lamp of the given size (tangent of half its angle). a and b in
/// [0, 1) choose the place on the lamp.
inline Eigen::Vector3d towards_lamp(const Eigen::Vector3d& direction, double size, double a, double b) {
  const Eigen::Vector3d side = direction.unitOrthogonal();
  const Eigen::Vector3d other = direction.cross(side);
  const double radius = size * std::sqrt(a);
  const double angle = 2 * std::numbers::pi * b;
  return (direction + radius * (std::cos(angle) * side + std::sin(angle) * other)).normalized();
}

/// A unit vector on the side of a surface that its normal points to, weighted by the cosine to the normal.
inline Eigen::Vector3d away_from_surface(const Eigen::Vector3d& normal, double a, double b) {
  const Eigen::Vector3d side = normal.unitOrthogonal();
  const Eigen::Vector3d other = normal.cross(side);
  const double radius = std::sqrt(a);
  const double angle = 2 * std::numbers::pi * b;
  return radius * (std::cos(angle) * side + std::sin(angle) * other) + std::sqrt(1 - a) * normal;
}

}  // namespace knitmech::picture
