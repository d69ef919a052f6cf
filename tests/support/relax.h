#pragma once

#include <functional>

#include "beam/internal_force.h"
#include "beam/nodal_inertia.h"
#include "model/state.h"
#include "solve/integrate.h"

namespace knitmech::test {

/// What acts on the beams besides their own stiffness: adds loads, or clears them where a node is held.
using ExtraLoads = std::function<void(const model::State&, model::NodalLoads&)>;

/// Clears every load of a node: it stays where it is.
inline void clamp(model::NodalLoads& loads, std::size_t node) {
  loads.force.set(node, {0, 0, 0});
  loads.moment.set(node, {0, 0, 0});
}

/// Brings beams to rest under loads by damped dynamics.
/// \param slowest angular frequency of the slowest vibration [1/s]; damped critically
/// \return largest speed at the end over the largest speed on the way [-]: how well they rest
inline double relax(const beam::Elements& elements, model::State& state, double slowest, const ExtraLoads& extra) {
  const beam::NodalInertia inertia = beam::lump_inertia(elements, 1.0);
  const double step = 0.8 * 2 / std::sqrt(inertia.highest_frequency_squared);
  const long n_steps = static_cast<long>(40 / (slowest * step));
  beam::ElementWork work(elements.size());
  model::NodalLoads loads(elements.size());
  double largest = 0;
  for (long i = 0; i < n_steps; ++i) {
    beam::set_internal_force(elements, state, step, work, loads);
    extra(state, loads);
    solve::integrate(inertia, loads, {step, step}, 2 * slowest, state);
    largest = std::max(largest, solve::largest_speed_squared(state));
  }
  return std::sqrt(solve::largest_speed_squared(state) / largest);
}

}  // namespace knitmech::test
