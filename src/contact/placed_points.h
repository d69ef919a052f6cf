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

/// Forces on places of one element, summed up with what each does to the two nodes.
struct RowLoad {
  Vector3 all{}, on_end{}, turns_start{}, turns_end{}, on_bow{};
};

/// Points of the material on several rows of places, side by side in arrays, so that they are computed side by side.
class PlacedPoints {
 public:
  void clear() { n_ = 0; }
  [[nodiscard]] std::size_t size() const { return n_; }

  /// Adds the points of a row as they are now. \return number of the first of them; the others follow
  std::size_t add(const PlaceRow& row, const Centreline& line, const model::State& state);

  [[nodiscard]] Vector3 position(std::size_t point) const { return {x_[point], y_[point], z_[point]}; }     ///< [mm]
  [[nodiscard]] Vector3 velocity(std::size_t point) const { return {vx_[point], vy_[point], vz_[point]}; }  ///< [mm/s]

  /// Depths by squares (cell_law.h) of n points below a place [mm].
  void depths_below(Vector3 place, double radii, std::size_t first, std::size_t n, double* depth) const;

  /// Adds a force on a point to the load of its row.
  void add_force(std::size_t point, Vector3 force, RowLoad& load) const {
    load.all = load.all + force;
    load.on_end = load.on_end + on_end_[point] * force;
    load.turns_start = load.turns_start + on_start_slope_[point] * force;
    load.turns_end = load.turns_end + on_end_slope_[point] * force;
    load.on_bow = load.on_bow + on_bow_[point] * force;
  }

 private:
  void make_room(std::size_t n);

  std::size_t n_ = 0;
  std::vector<double> on_end_, on_start_slope_, on_end_slope_, on_bow_;  ///< weights, see HermiteWeights
  std::vector<double> x_, y_, z_, vx_, vy_, vz_;
};

/// What the load of a row does to the nodes of its element.
[[nodiscard]] EndLoads to_nodes(const ElementLine& element, const RowLoad& load);

}  // namespace knitmech::contact
