#pragma once

#include "base/thread_team.h"
#include "beam/nodal_inertia.h"
#include "model/state.h"

namespace knitmech::solve {

/// Two steps of the leapfrog: velocities live half a step before and after the positions.
struct StepLengths {
  double before = 0;  ///< [s], from the last positions to the present ones
  double after = 0;   ///< [s], from the present positions to the next ones
  [[nodiscard]] double mean() const { return 0.5 * (before + after); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(before, after);
  }
};

/// Carries velocities over the mean of both steps and positions over the step after:
///
///     v+ = ((1 - alpha h / 2) v- + h F / m) / (1 + alpha h / 2),  h = (before + after) / 2
///     x+ = x + after v+,   q+ = exp(after w+) q
///
/// and the same for angular velocities, with the rotary inertia. Advances state.time.
/// \param loads F on nodes that move for themselves; with relative masses m a in place of F, see SelectiveMass
/// \param mass_damping alpha [1/s]
void integrate(const beam::NodalInertia& inertia, const model::NodalLoads& loads, StepLengths step, double mass_damping,
               model::State& state, const base::ThreadTeam& team = base::ThreadTeam(1));

/// What mass damping takes away in the step that integrate() would do [mJ]: alpha h m v^2 summed over the nodes, v the
/// mean of v- and v+, and the same for their turning.
[[nodiscard]] double mass_damping_loss(const beam::NodalInertia& inertia, const model::NodalLoads& loads,
                                       StepLengths step, double mass_damping, const model::State& state,
                                       const base::ThreadTeam& team = base::ThreadTeam(1));

/// Kinetic energy at the time of the positions [mJ]: from v = v- + before / 2 F / m, with that of the relative masses.
[[nodiscard]] double kinetic_energy(const beam::NodalInertia& inertia, const model::NodalLoads& loads, StepLengths step,
                                    const model::State& state, const base::ThreadTeam& team = base::ThreadTeam(1));

/// Largest speed of a node, squared [mm^2/s^2]; not a number if any velocity is not one or is infinite.
[[nodiscard]] double largest_speed_squared(const model::State& state,
                                           const base::ThreadTeam& team = base::ThreadTeam(1));

}  // namespace knitmech::solve
