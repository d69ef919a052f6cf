#include "solve/explicit_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "beam/section_results.h"
#include "solve/constants.h"

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
      elements_(beam::make_elements(model, settings.mass_scaling, settings.bulk_viscosity)),
      inertia_(beam::lump_inertia(elements_, settings.mass_scaling)),
      work_(model.nodes.size()),
      folds_(elements_),
      contact_(model),
      ties_(model),
      grips_(model),
      state_(state_at_rest(model)),
      loads_(model.nodes.size()),
      smallest_radius_(smallest_radius(model)) {
  const double lightest = *std::min_element(inertia_.mass.begin(), inertia_.mass.end());
  first_step_ = stable_step_for(kExpectedContacts * 2 * model.contact_stiffness / (2 * lightest));
  step_in_use_ = first_step_;
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
  const double speed_squared = largest_speed_squared(state_);
  is_finite_ = !std::isnan(speed_squared);
  double allowed = stable_step_for(contact_.highest_frequency_squared(inertia_.mass, inertia_.rotary));
  if (speed_squared > 0) allowed = std::min(allowed, kLargestMove * smallest_radius_ / std::sqrt(speed_squared));

  if (allowed < step_in_use_) {
    step_in_use_ = kStepReserve * allowed;
    calm_looks_ = 0;
  } else if (allowed > kStepGrowth * step_in_use_ && ++calm_looks_ >= kCalmLooks) {
    step_in_use_ = std::min(kStepGrowth * step_in_use_, first_step_);
    calm_looks_ = 0;
  }
}

void ExplicitSolver::compute_forces() {
  beam::set_internal_force(elements_, state_, kick_, work_, loads_);
  folds_.add_moments(state_, loads_);
  contact_.add_forces(state_, step_.before, loads_);
  largest_penetration_ = std::max(largest_penetration_, contact_.largest_penetration());
  forces_are_current_ = true;
}

void ExplicitSolver::evaluate() {
  if (!forces_are_current_) compute_forces();
}

void ExplicitSolver::step() {
  if (steps_ % kWatchInterval == 0) look_at_stable_step();
  step_.after = step_in_use_;
  if (steps_ == 0) step_.before = step_.after;

  evaluate();
  const bool damped = settings_.mass_damping > 0;
  const model::VectorArray velocity_before = damped ? state_.velocity : model::VectorArray();
  const model::VectorArray angular_before = damped ? state_.angular_velocity : model::VectorArray();
  ties_.apply(contact_.centreline(), inertia_, step_, settings_.mass_damping, state_, loads_);
  grips_.apply(inertia_, step_, settings_.mass_damping, state_, loads_);
  const double h = step_.mean();
  impulse_top_ += h * grips_.force_top();
  impulse_bottom_ += h * grips_.force_bottom();
  impulse_time_ += h;
  integrate(inertia_, loads_, step_, settings_.mass_damping, state_);
  for (std::size_t i = 0; i < velocity_before.size(); ++i) {
    const Vector3 v = 0.5 * (velocity_before.at(i) + state_.velocity.at(i));
    const Vector3 w = 0.5 * (angular_before.at(i) + state_.angular_velocity.at(i));
    mass_damping_loss_ += settings_.mass_damping * h * (inertia_.mass[i] * dot(v, v) + inertia_.rotary[i] * dot(w, w));
  }
  kick_ = h;
  step_.before = step_.after;
  forces_are_current_ = false;
  ++steps_;
}

double ExplicitSolver::width() const {
  const int middle = (1 + *std::max_element(model_.course.begin(), model_.course.end())) / 2;
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (std::size_t node = 0; node < model_.nodes.size(); ++node) {
    if (model_.course[node] != middle || model_.wale[node] == knit::kNoWale) continue;
    low = std::min(low, state_.position.x[node]);
    high = std::max(high, state_.position.x[node]);
  }
  return high - low;
}

model::HistoryRow ExplicitSolver::history() {
  evaluate();
  model::HistoryRow row;
  row.time = state_.time;
  row.displacement = model_.test.displacement(state_.time);
  row.strain = row.displacement / model_.test.gauge_length;
  if (impulse_time_ > 0) {
    row.force_top = impulse_top_ / impulse_time_;
    row.force_bottom = impulse_bottom_ / impulse_time_;
  }
  impulse_top_ = impulse_bottom_ = impulse_time_ = 0;
  row.external_work = grips_.work();
  row.internal_energy = beam::strain_energy(elements_, state_) + folds_.energy();
  model::NodalLoads free_loads = loads_;
  ties_.add_last_forces(free_loads);
  grips_.clear_loads(free_loads);  // what the fabric does to a grip does not accelerate it
  row.kinetic_energy = steps_ == 0 ? 0 : kinetic_energy(inertia_, free_loads, step_, state_);
  row.contact_energy = contact_.energy();
  row.friction_loss = contact_.friction_loss();
  row.damping_loss = beam::damping_loss(work_) + mass_damping_loss_;
  row.width = width();
  contact_.check_crossings();
  const std::vector<contact::ContactPoint> points = contact_.points();
  row.contacts = static_cast<int>(points.size());
  for (const contact::ContactPoint& point : points) {
    row.normal_force += point.load;
    row.largest_elastic_slip = std::max(row.largest_elastic_slip, length(point.stick.elastic_slip));
  }
  row.largest_penetration = contact_.largest_penetration();
  row.step = step_in_use_;
  return row;
}

model::Frame ExplicitSolver::frame(int index, const model::HistoryRow& row) const {
  model::Frame frame;
  frame.index = index;
  frame.history = row;
  const std::size_t n = state_.position.size();
  frame.points.resize(n);
  frame.rotations.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    frame.points[i] = {state_.position.x[i], state_.position.y[i], state_.position.z[i]};
    frame.rotations[i] = {state_.rotation.w[i], state_.rotation.x[i], state_.rotation.y[i], state_.rotation.z[i]};
  }
  beam::set_section_results(elements_, state_, frame);
  contact_.set_contact_results(frame);
  ties_.set_results(frame);
  return frame;
}

}  // namespace knitmech::solve
