#pragma once

#include <cstddef>
#include <vector>

#include "base/left_out.h"
#include "base/thread_team.h"
#include "beam/elements.h"
#include "model/model.h"
#include "model/state.h"

namespace knitmech::beam {

/// Finds the elements whose axial force has reached the strength of their section (Model::strengths).
///
/// The force is that of the axial law alone, without viscosity, which follows the strain rate and so the noise of a
/// dynamic simulation. As it depends on the chord's length only, the lengths are compared: of all elements at once,
/// and nothing is done where no section has a strength.
class StrengthWatch {
 public:
  StrengthWatch(const model::Model& model, const Elements& elements);

  [[nodiscard]] bool is_needed() const { return is_needed_; }

  /// Elements at or beyond their strength, the most overloaded (by length over length at the strength) first.
  [[nodiscard]] std::vector<std::size_t> overloaded(const model::State& state,
                                                    const base::ThreadTeam& team = base::ThreadTeam(1)) const;

  /// Forgets an element, which has broken.
  void remove(std::size_t element) { inverse_limit_squared_[element] = 0; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(is_needed_), inverse_limit_squared_);
  }

 private:
  bool is_needed_ = false;
  std::vector<double> inverse_limit_squared_;  ///< [1/mm^2], of the chord at the strength; 0: never breaks
};

}  // namespace knitmech::beam
