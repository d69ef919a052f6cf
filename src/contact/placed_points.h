#pragma once

#include <cstddef>
#include <vector>

#include "contact/centreline.h"
#include "model/state.h"

namespace knitmech::contact {

/// Evenly spaced places on an element: share = first + i step.
struct PlaceRow {
  std::int32_t element = 0;
  double first = 0, step = 0;
  std::size_t n = 0;
};

/// Points that are computed at once; rows begin at multiples of it. What lies between the end of a row and the next one
/// are points as well, on which there are no forces.
inline constexpr std::size_t kPointsAtOnce = 8;
constexpr std::size_t rounded_up(std::size_t n) {
  return (n + kPointsAtOnce - 1) / kPointsAtOnce * kPointsAtOnce;
}

/// Points of the material on several rows of places, side by side in arrays, so that they are computed side by side.
class PlacedPoints {
 public:
  void clear() { n_ = 0; }
  [[nodiscard]] std::size_t size() const { return n_; }

  /// Adds the points of a row as they are now, without forces. \return number of the first of them; the others follow
  std::size_t add(const PlaceRow& row, const Centreline& line, const model::State& state);

  [[nodiscard]] Vector3 position(std::size_t point) const { return {x_[point], y_[point], z_[point]}; }     ///< [mm]
  [[nodiscard]] Vector3 velocity(std::size_t point) const { return {vx_[point], vy_[point], vz_[point]}; }  ///< [mm/s]

  /// Depths by squares (cell_law.h) of n points below a place [mm], and of more: up to rounded_up(n).
  void depths_below(Vector3 place, double radii, std::size_t first, std::size_t n, double* depth) const;

  /// Sums over rounded_up(n) points: of weights, of weights times positions and times velocities.
  struct WeightedSum {
    double weight = 0;
    Vector3 position{}, velocity{};
  };
  [[nodiscard]] WeightedSum sum(std::size_t first, std::size_t n, const double* weight) const;

  /// Adds the force  weight (by (x - from) + besides)  on each of rounded_up(n) points.
  void add_forces(std::size_t first, std::size_t n, const double* weight, double by, Vector3 from, Vector3 besides);
  void add_force(std::size_t point, Vector3 force) {
    fx_[point] += force.x;
    fy_[point] += force.y;
    fz_[point] += force.z;
  }

  /// What the forces on the n points of a row do to the nodes of its element.
  [[nodiscard]] EndLoads to_nodes(const ElementLine& element, std::size_t first, std::size_t n) const;

 private:
  void make_room(std::size_t n);

  std::size_t n_ = 0;
  std::vector<double> on_end_, on_start_slope_, on_end_slope_, on_bow_;  ///< weights, see HermiteWeights
  std::vector<double> x_, y_, z_, vx_, vy_, vz_, fx_, fy_, fz_;
};

}  // namespace knitmech::contact
