#pragma once

#include <cstdint>
#include <vector>

#include "contact/centreline.h"

namespace knitmech::contact {

/// Points that stay at their places of the yarns and move with them: positions and velocities from the nodes, forces
/// back to the nodes with the same weights, so that both do the same work.
///
/// Points come in blocks that lie on one element each; the vectors have one entry per point.
class PlacedPoints {
 public:
  void clear();
  /// Adds a block of points. \param shares of the way along the element \return index of its first point
  std::size_t add(std::int32_t element, const std::vector<double>& shares);

  [[nodiscard]] std::size_t size() const { return x_.size(); }
  [[nodiscard]] YarnPlace place(std::size_t point) const { return {element_[point], share_[point]}; }
  [[nodiscard]] Vector3 position(std::size_t point) const { return {x_[point], y_[point], z_[point]}; }     ///< [mm]
  [[nodiscard]] Vector3 velocity(std::size_t point) const { return {vx_[point], vy_[point], vz_[point]}; }  ///< [mm/s]

  /// Takes positions and velocities from the nodes, and forgets the forces.
  void update(const Centreline& line, const model::State& state);
  void add_force(std::size_t point, Vector3 force) {
    fx_[point] += force.x;
    fy_[point] += force.y;
    fz_[point] += force.z;
  }
  void give_forces(const Centreline& line, model::NodalLoads& loads) const;

 private:
  struct Block {
    std::int32_t element;
    std::size_t first, count;
  };
  std::vector<Block> blocks_;
  std::vector<std::int32_t> element_;
  std::vector<double> share_;
  std::vector<double> on_end_, on_start_slope_, on_end_slope_, on_bow_;  ///< weights, see HermiteWeights
  std::vector<double> x_, y_, z_, vx_, vy_, vz_, fx_, fy_, fz_;
};

}  // namespace knitmech::contact
