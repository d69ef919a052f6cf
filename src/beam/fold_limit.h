#pragma once

#include <cstddef>
#include <vector>

#include "base/left_out.h"
#include "base/thread_team.h"
#include "beam/elements.h"
#include "model/state.h"

namespace knitmech::beam {

/// Keeps the elements of soft yarns from folding over.
///
/// A yarn of loose filaments under tension makes hairpins tighter than it is thick, within one element. There a real
/// yarn lies on itself and goes no further; contact cannot see that between neighbouring elements, and the element,
/// which all but lacks bending stiffness, would turn on towards 360 degrees, where it has no mid frame. So a relative
/// rotation theta of the two nodes beyond kFold is resisted by
///
///     W = k / 2 (|theta| - kFold)^2,   k = EA L0 / 8,
///
/// which holds against a tension of several per cent of EA and, as NodalInertia makes room for it, never rules the time
/// step. Only yarns that bend more
/// easily than a solid one of their diameter and EA have it.
class FoldLimit {
 public:
  static constexpr double kFold = 2.618;  ///< [rad], 150 degrees

  explicit FoldLimit(const Elements& elements);

  /// Adds the moments on the nodes.
  void add_moments(const model::State& state, model::NodalLoads& loads,
                   const base::ThreadTeam& team = base::ThreadTeam(1));
  /// Forgets an element, which has broken.
  void remove(std::size_t element);
  /// At the last call of add_moments [mJ].
  [[nodiscard]] double energy() const { return energy_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(soft_, energy_of_block_, energy_of_last_), energy_);
  }

 private:
  struct SoftElement {
    std::size_t node;
    double stiffness;  ///< k [N mm]
  };
  [[nodiscard]] static double add_moment(const SoftElement& element, const model::State& state,
                                         model::NodalLoads& loads);

  std::vector<SoftElement> soft_;
  /// [mJ], of the blocks (base/blocks.h) without their last elements, and of these.
  std::vector<double> energy_of_block_, energy_of_last_;
  double energy_ = 0;
};

}  // namespace knitmech::beam
