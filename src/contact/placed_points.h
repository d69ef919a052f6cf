#pragma once

#include <cstdint>
#include <vector>

#include "contact/centreline.h"

namespace knitmech::contact {

/// Points that stay at their places of the yarns and move with them: positions and velocities from the nodes, forces
/// back to the nodes with the same weights, so that both do the same work.
///
/// Points come in blocks that lie on one element each, and a step brings only those blocks up to date that it needs;
/// the vectors have one entry per point.
class PlacedPoints {
 public:
  void clear();
  /// Adds a block of points. \param shares of the way along the element \return index of its first point; that of the
  /// block is the number of blocks before
  std::size_t add(std::int32_t element, const std::vector<double>& shares);
  [[nodiscard]] std::size_t n_blocks() const { return blocks_.size(); }

  [[nodiscard]] std::size_t size() const { return x_.size(); }
  [[nodiscard]] YarnPlace place(std::size_t point) const { return {element_[point], share_[point]}; }
  [[nodiscard]] Vector3 position(std::size_t point) const { return {x_[point], y_[point], z_[point]}; }     ///< [mm]
  [[nodiscard]] Vector3 velocity(std::size_t point) const { return {vx_[point], vy_[point], vz_[point]}; }  ///< [mm/s]

  /// Begins a step, in which nothing is up to date yet.
  void begin_step() { ++step_, in_use_.clear(); }
  /// Takes positions and velocities of a block from the nodes and forgets its forces, if this step has not yet.
  void bring(std::size_t block, const Centreline& line, const model::State& state) {
    if (blocks_[block].step == step_) return;
    update(blocks_[block], line, state);
    in_use_.push_back(block);
  }
  void add_force(std::size_t point, Vector3 force) {
    fx_[point] += force.x;
    fy_[point] += force.y;
    fz_[point] += force.z;
  }
  /// Gives the forces on all blocks of this step to the nodes.
  void give_forces(const Centreline& line, model::NodalLoads& loads) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(blocks_, in_use_, step_, element_, share_, on_end_, on_start_slope_, on_end_slope_, on_bow_, x_, y_, z_,
            vx_, vy_, vz_, fx_, fy_, fz_);
  }

 private:
  struct Block {
    std::int32_t element = 0;
    std::size_t first = 0, count = 0;
    long step = 0;  ///< in which it was brought up to date

    template <class Archive>
    void serialize(Archive& archive) {
      archive(element, first, count, step);
    }
  };
  void update(Block& block, const Centreline& line, const model::State& state);

  std::vector<Block> blocks_;
  std::vector<std::size_t> in_use_;  ///< blocks of this step
  long step_ = 0;
  std::vector<std::int32_t> element_;
  std::vector<double> share_;
  std::vector<double> on_end_, on_start_slope_, on_end_slope_, on_bow_;  ///< weights, see HermiteWeights
  std::vector<double> x_, y_, z_, vx_, vy_, vz_, fx_, fy_, fz_;
};

}  // namespace knitmech::contact
