#pragma once

#include "beam/elements.h"
#include "model/state.h"

namespace knitmech::beam {

/// Loads of the elements on their nodes, kept between the two passes of add_internal_force, and the viscous loss so
/// far.
struct ElementWork {
  model::VectorArray force_a, moment_a, moment_b;  ///< one entry per element
  std::vector<double> approach;                    ///< [mm/s], axial speed difference that bulk viscosity acted on
  std::vector<double> damping_loss;                ///< [mJ], by bulk viscosity since the start, per element

  explicit ElementWork(std::size_t n) : force_a(n), moment_a(n), moment_b(n), approach(n, 0.0), damping_loss(n, 0.0) {}
};

/// Sets `loads` to the forces and moments of all elements (element.h) and of their bulk viscosity on the nodes.
///
/// First every element by itself, then every node gathers from the element before and the element behind it: no two
/// writers of one place, and always the same order of summation.
/// The viscous force F of a step works against the mean of the speeds before and after it, v- and v+; its loss
/// F (v- + v+) / 2 h is therefore added at the next call, when v+ is known.
/// \param step h [s], over which the loads of the call before have acted
void set_internal_force(const Elements& elements, const model::State& state, double step, ElementWork& work,
                        model::NodalLoads& loads);

/// Strain energy of all elements [mJ].
[[nodiscard]] double strain_energy(const Elements& elements, const model::State& state);

/// Energy dissipated by bulk viscosity since the start [mJ].
[[nodiscard]] double damping_loss(const ElementWork& work);

}  // namespace knitmech::beam
