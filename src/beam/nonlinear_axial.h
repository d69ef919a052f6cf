#pragma once

#include <cstddef>
#include <vector>

#include "base/thread_team.h"
#include "beam/elements.h"
#include "model/frame.h"
#include "model/model.h"
#include "model/state.h"
#include "yarn/axial_law.h"

namespace knitmech::beam {

/// Elements that follow a measured axial law N(epsilon) in place of EA epsilon.
///
/// The loop over all elements (internal_force.h) knows EA alone. In a given state a law is the same as the stiffness
///
///     EA = N(epsilon) / epsilon        at epsilon <= 0 the law's slope at zero,
///
/// so that is set before the loop: its forces are then those of the law, which are the derivatives of
///
///     W = L0 (integral of N from 0 to epsilon) + ...
///
/// Energies of the loop have N epsilon / 2 in place of the integral; the difference is given here. Costs nothing where
/// no element has a law.
class NonlinearAxial {
 public:
  explicit NonlinearAxial(const model::Model& model);

  /// Sets Elements::axial of the elements with a law for a state.
  void set_secants(const model::State& state, Elements& elements,
                   const base::ThreadTeam& team = base::ThreadTeam(1)) const;

  /// What strain_energy() lacks after set_secants() for the same state [mJ].
  [[nodiscard]] double energy_beyond_secants(const Elements& elements, const model::State& state,
                                             const base::ThreadTeam& team = base::ThreadTeam(1)) const;

  /// Puts the energy of the law into the stretch_energy of a frame that has its section results.
  void correct_stretch_energy(const Elements& elements, model::Frame& frame) const;

  /// Forgets an element, which has broken.
  void remove(std::size_t element);

 private:
  struct LawElement {
    std::size_t element;
    std::size_t law;  ///< index into laws_
  };

  std::vector<yarn::AxialLaw> laws_;
  std::vector<LawElement> with_law_;
};

}  // namespace knitmech::beam
