#pragma once

#include <cstddef>
#include <vector>

#include "contact/centreline.h"
#include "model/frame.h"
#include "model/model.h"
#include "model/state.h"

namespace knitmech::contact {

/// Ties between places of yarns that cross (Model::ties): two points that were one at the start, halfway between both
/// centrelines, are held together by a stiff spring. Each point is fixed to the section of its yarn,
///
///     p = x(s) + R a,   R the rotation of the node nearest to the place, a the way from the centreline at the start,
///
/// so that the yarns keep their relative position however the pair turns as a whole, and W = K |p_b - p_a|^2 / 2 has
/// forces and moments that are its exact derivatives. Nothing keeps the yarns from turning about the point.
class YarnTies {
 public:
  explicit YarnTies(const model::Model& model);

  /// Adds the forces on the nodes. \param line the same centreline that the contact sees, up to date
  void add_forces(const Centreline& line, const model::State& state, model::NodalLoads& loads);

  /// Stored in the springs at the last call of add_forces [mJ].
  [[nodiscard]] double energy() const;
  /// By which the points of a tie have come apart at the last call of add_forces, the largest [mm].
  [[nodiscard]] double largest_stretch() const;
  /// Bound of what the ties add to the square of the highest frequency, see FrequencyBound.
  [[nodiscard]] double highest_frequency_squared(const Centreline& line, const std::vector<double>& mass,
                                                 const std::vector<double>& rotary) const;
  /// Fills the tie_force of a frame whose points are set.
  void set_results(const Centreline& line, model::Frame& frame) const;

 private:
  struct Anchor {
    YarnPlace place;
    std::size_t node;  ///< nearest, which the arm turns with
    Vector3 arm;       ///< a [mm], stress-free
  };
  struct Pair {
    Anchor first, second;
    Vector3 force{0, 0, 0};  ///< on the first, at the last call of add_forces [N]
  };

  double stiffness_;  ///< K [N/mm]
  std::vector<Pair> pairs_;
};

}  // namespace knitmech::contact
