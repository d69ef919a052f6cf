#pragma once

#include "base/left_out.h"
#include "base/thread_team.h"
#include "beam/elements.h"
#include "model/state.h"

namespace knitmech::beam {

/// What is kept from one call of set_internal_force to the next, and the viscous loss so far.
struct ElementWork {
  std::vector<double> approach;      ///< [mm/s], per element, axial speed difference that bulk viscosity acted on
  std::vector<double> damping_loss;  ///< [mJ], per block of elements, by bulk viscosity since the start
  /// Per block of elements, the loads of its last one on its second node where that is another thread's.
  model::NodalLoads on_next_block;

  explicit ElementWork(std::size_t n_nodes);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(approach, damping_loss, base::left_out(on_next_block));
  }
};

/// Sets `loads` to the forces and moments of all elements (element.h) and of their bulk viscosity on the nodes.
///
/// Block by block (base/blocks.h): first every element by itself, then every node gathers from the element before and
/// the element behind it. So no two threads write to one place, what passes from elements to nodes stays in the first
/// cache, and the order of summation is always the same.
/// The viscous force F of a step works against the mean of the speeds before and after it, v- and v+; its loss
/// F (v- + v+) / 2 h is therefore added at the next call, when v+ is known.
/// \param step h [s], over which the loads of the call before have acted
void set_internal_force(const Elements& elements, const model::State& state, double step, ElementWork& work,
                        model::NodalLoads& loads, const base::ThreadTeam& team = base::ThreadTeam(1));

/// Strain energy of all elements [mJ].
[[nodiscard]] double strain_energy(const Elements& elements, const model::State& state,
                                   const base::ThreadTeam& team = base::ThreadTeam(1));

/// The part of it by axial strain and shear [mJ].
[[nodiscard]] double stretch_energy(const Elements& elements, const model::State& state,
                                    const base::ThreadTeam& team = base::ThreadTeam(1));

/// Energy dissipated by bulk viscosity since the start [mJ].
[[nodiscard]] double damping_loss(const ElementWork& work);

}  // namespace knitmech::beam
