#include "solve/explicit_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solve/constants.h"
#include "solve/contact_frequency.h"

namespace knitmech::solve {

namespace {

model::State state_at_rest(const model::Model& model) {
  model::State state(model.nodes.size());
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    state.position.set(i, {model.nodes[i].x(), model.nodes[i].y(), model.nodes[i].z()});
  }
  return state;
}

double smallest_radius(const model::Model& model) {
  double smallest = std::numeric_limits<double>::max();
  for (const yarn::Section& section : model.sections) smallest = std::min(smallest, 0.5 * section.diameter);
  return smallest;
}

}  // namespace

ExplicitSolver::ExplicitSolver(const model::Model& model, const ExplicitSettings& settings)
    : model_(model),
      settings_(settings),
      team_(static_cast<std::size_t>(settings.threads)),
      elements_(beam::make_elements(model, settings.mass_scaling, settings.bulk_viscosity)),
      inertia_(beam::lump_inertia(elements_, settings.mass_scaling, settings.finest_length)),
      work_(model.nodes.size()),
      nonlinear_(model),
      folds_(elements_),
      contact_(model),
      ties_(model),
      grips_(model),
      masses_(inertia_, GivenMotion::by_grips(model)),
      pull_(model, inertia_, settings.adapts_pace),
      state_(state_at_rest(model)),
      loads_(model.nodes.size()),
      smallest_radius_(smallest_radius(model)),
      breaks_(model, elements_, settings.mass_scaling),
      pieces_(model) {
  const double lightest = *std::min_element(masses_.felt().begin(), masses_.felt().end());
  first_step_ = stable_step_for(kExpectedContacts * 2 * model.contact_stiffness / (2 * lightest));
  step_in_use_ = first_step_;
  elements_.forget_set_up();
}

/// Squares of frequencies add up: the highest of beams and contacts together is at most the sum of both bounds. Bulk
/// viscosity takes the step down by sqrt(1 + b1^2) - b1.
double ExplicitSolver::stable_step_for(double contact_frequency_squared) const {
  const double frequency_squared = inertia_.highest_frequency_squared + contact_frequency_squared;
  const double b1 = settings_.bulk_viscosity;
  return settings_.step_factor * 2 / std::sqrt(frequency_squared) * (std::sqrt(1 + b1 * b1) - b1);
}

/// The step shrinks at once when it has to and grows seldom: every change of the step feeds or drains the fastest
/// vibrations of a leapfrog, so a step that follows every contact would heat the yarns up.
void ExplicitSolver::look_at_stable_step() {
  const double speed_squared = largest_speed_squared(state_, team_);
  is_finite_ = !std::isnan(speed_squared);
  double allowed = stable_step_for(highest_frequency_squared(contact_.springs(), inertia_, masses_));
  if (speed_squared > 0) allowed = std::min(allowed, kLargestMove * smallest_radius_ / std::sqrt(speed_squared));

  if (allowed < step_in_use_) {
    step_in_use_ = kStepReserve * allowed;
    calm_looks_ = 0;
  } else if (allowed > kStepGrowth * step_in_use_ && ++calm_looks_ >= kCalmLooks) {
    step_in_use_ = std::min(kStepGrowth * step_in_use_, first_step_);
    calm_looks_ = 0;
  }
}

void ExplicitSolver::compute_forces(double viscous_time, double friction_time) {
  nonlinear_.set_secants(state_, elements_, team_);
  beam::set_internal_force(elements_, state_, viscous_time, work_, loads_, team_);
  folds_.add_moments(state_, loads_, team_);
  contact_.add_forces(state_, friction_time, loads_, team_);
  largest_penetration_ = std::max(largest_penetration_, contact_.largest_penetration());
  forces_are_current_ = true;
}

void ExplicitSolver::evaluate() {
  if (!forces_are_current_) compute_forces(kick_, step_.before);
}

void ExplicitSolver::step() {
  if (steps_ % kWatchInterval == 0) look_at_stable_step();
  if (steps_ == 0) step_.before = step_in_use_;
  evaluate();
  step_.after = step_in_use_;
  if (pull_.has_to_look(steps_)) pull_.look(internal_energy(), kinetic_energy(), state_);
  const double speed = pull_.advance(step_, state_, loads_);
  ties_.apply(contact_.centreline(), inertia_, step_, settings_.mass_damping, state_, loads_);
  grips_.apply(inertia_, masses_, step_, settings_.mass_damping, state_, speed, loads_, team_);
  const double h = step_.mean();
  grip_forces_.add(displacement(), {grips_.force_top(), grips_.force_bottom()}, h);
  pull_.add_forces(grips_.force_top(), grips_.force_bottom(), h);
  mass_damping_loss_ += mass_damping_loss(inertia_, loads_, step_, settings_.mass_damping, state_, team_);
  integrate(inertia_, loads_, step_, settings_.mass_damping, state_, team_);
  kick_ = h;
  step_.before = step_.after;
  forces_are_current_ = false;
  ++steps_;
  look_for_breaks();
}

}  // namespace knitmech::solve
