// Yarns that break while the solver runs.

#include <algorithm>
#include <cmath>
#include <utility>

#include "solve/constants.h"
#include "solve/explicit_solver.h"

namespace knitmech::solve {

void ExplicitSolver::look_for_breaks() {
  const std::vector<std::size_t> found = breaks_.find(state_, team_);
  if (found.empty()) return;
  evaluate();
  for (const std::size_t element : found) broken_.push_back(break_of(element));
  // With a lost crossing the run fails; contact made anew would forget it.
  if (model_.test.on_break == model::OnBreak::go_on && !lost_crossing()) cut(found);
}

model::YarnBreak ExplicitSolver::break_of(std::size_t element) const {
  const Vector3 start = state_.position.at(element);
  const Vector3 end = state_.position.at(element + 1);
  const Vector3 middle = 0.5 * (start + end);
  model::YarnBreak event;
  event.strain = strain();
  event.element = static_cast<int>(element);
  event.axial_strain = length(end - start) * elements_.inverse_length[element] - 1;
  event.axial_force = elements_.axial[element] * event.axial_strain;
  event.position = {middle.x, middle.y, middle.z};
  return event;
}

/// Forces and energies are computed twice for the same state, whole and cut; the difference of the energies is lost.
void ExplicitSolver::cut(const std::vector<std::size_t>& elements) {
  const auto stored = [&] { return internal_energy() + contact_.energy(); };
  const double stored_before = stored();
  const model::NodalLoads loads_before = loads_;
  gather_ravelled();
  pieces_.cut(elements);
  for (const std::size_t element : elements) {
    limit_step_to_snap(element);
    take_out(element);
  }
  make_contact_anew();
  compute_forces(0, 0);
  keep_velocities_of_now(loads_before);
  break_loss_ += stored_before - stored();
}

/// The velocities that are kept are those of half a step ago, and what they became since is owed to the forces before
/// the cut. Corrected for it, the velocities at the time of the cut, and the kinetic energy, stay what they were.
void ExplicitSolver::keep_velocities_of_now(const model::NodalLoads& loads_before) {
  const std::size_t n = state_.velocity.size();
  model::NodalLoads change(n);
  for (std::size_t i = 0; i < n; ++i) {
    change.force.set(i, loads_before.force.at(i) - loads_.force.at(i));
    change.moment.set(i, loads_before.moment.at(i) - loads_.moment.at(i));
  }
  grips_.clear_loads(change);
  const double half = 0.5 * step_.before;
  for (std::size_t i = 0; i < n; ++i) {
    state_.velocity.add(i, (half / inertia_.mass[i]) * change.force.at(i));
    state_.angular_velocity.add(i, (half / inertia_.rotary[i]) * change.moment.at(i));
  }
}

void ExplicitSolver::take_out(std::size_t element) {
  nonlinear_.remove(element);
  folds_.remove(element);
  ties_.remove(element);
  for (auto* stiffness :
       {&elements_.axial, &elements_.shear, &elements_.torsion, &elements_.bending, &elements_.viscosity}) {
    (*stiffness)[element] = 0;
  }
}

void ExplicitSolver::make_contact_anew() {
  earlier_.friction_loss += contact_.friction_loss();
  earlier_.crossing_checks += contact_.crossing_checks();
  contact_ = contact::YarnContact(pieces_.model());
  n_gathered_ = 0;
}

/// Brings the parts that know the yarns up to date with pieces_, for a solver that goes on where another one was.
void ExplicitSolver::make_parts_of_pieces() {
  if (pieces_.elements().empty()) return;
  for (const int element : pieces_.elements()) take_out(static_cast<std::size_t>(element));
  contact_ = contact::YarnContact(pieces_.model());
}

/// A broken end springs back at the speed strain c before the next look at the step.
void ExplicitSolver::limit_step_to_snap(std::size_t element) {
  const double speed = break_of(element).axial_strain * breaks_.wave_speed(element);
  step_in_use_ = std::min(step_in_use_, kLargestMove * smallest_radius_ / speed);
  calm_looks_ = 0;
}

void ExplicitSolver::gather_ravelled() {
  for (; n_gathered_ < contact_.ravelled().size(); ++n_gathered_) {
    untold_.push_back(pieces_.ravelling_of(contact_.ravelled()[n_gathered_]));
  }
}

std::vector<model::Ravelling> ExplicitSolver::take_ravelled() {
  gather_ravelled();
  return std::exchange(untold_, {});
}

}  // namespace knitmech::solve
