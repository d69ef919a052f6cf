#include "solve/grips.h"

namespace knitmech::solve {

namespace {

/// Load that takes a velocity to a target within the coming step; see integrate().
double load_for(double target, double velocity, double inertia, double h, double damping) {
  return inertia * ((1 + damping) * target - (1 - damping) * velocity) / h;
}

}  // namespace

Grips::Grips(const model::Model& model)
    : test_(model.test),
      held_(model.node_sets.at(model.test.held_set)),
      driven_(model.node_sets.at(model.test.driven_set)) {}

void Grips::apply(const beam::NodalInertia& inertia, const SelectiveMass& masses, StepLengths step, double mass_damping,
                  const model::State& state, double speed, model::NodalLoads& loads, const base::ThreadTeam& team) {
  const double h = step.mean();
  const double damping = 0.5 * mass_damping * h;
  const auto hold = [&](std::size_t i, std::vector<double>& load, const std::vector<double>& velocity,
                        const std::vector<double>& mass) { load[i] = load_for(0, velocity[i], mass[i], h, damping); };
  const auto hold_rotation = [&](std::size_t i) {
    hold(i, loads.moment.x, state.angular_velocity.x, inertia.rotary);
    hold(i, loads.moment.y, state.angular_velocity.y, inertia.rotary);
    hold(i, loads.moment.z, state.angular_velocity.z, inertia.rotary);
  };

  on_held_.clear();
  for (const int node : held_) {
    const auto i = static_cast<std::size_t>(node);
    on_held_.push_back(loads.force.y[i]);
    hold(i, loads.force.x, state.velocity.x, inertia.mass);
    hold(i, loads.force.y, state.velocity.y, inertia.mass);
    hold(i, loads.force.z, state.velocity.z, inertia.mass);
    hold_rotation(i);
  }
  on_driven_.clear();
  for (const int node : driven_) {
    const auto i = static_cast<std::size_t>(node);
    on_driven_.push_back(loads.force.y[i]);
    loads.force.y[i] = load_for(speed, state.velocity.y[i], inertia.mass[i], h, damping);
    if (test_.grips == model::Grips::clamped) {
      hold(i, loads.force.x, state.velocity.x, inertia.mass);
      hold(i, loads.force.z, state.velocity.z, inertia.mass);
    }
    hold_rotation(i);
  }
  masses.share(loads, team);
  add_up(masses, h, state, speed, loads);
}

/// What a grip adds to the load of the fabric on a node is what is missing to its inertia.
void Grips::add_up(const SelectiveMass& masses, double h, const model::State& state, double speed,
                   const model::NodalLoads& loads) {
  const auto pull_on = [&](std::size_t i, double from_fabric) {
    return loads.force.y[i] + masses.from_neighbours(i, loads.force.y) - from_fabric;
  };
  force_bottom_ = 0;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    force_bottom_ -= pull_on(static_cast<std::size_t>(held_[k]), on_held_[k]);
  }
  force_top_ = 0;
  for (std::size_t k = 0; k < driven_.size(); ++k) {
    const auto i = static_cast<std::size_t>(driven_[k]);
    const double pull = pull_on(i, on_driven_[k]);
    force_top_ += pull;
    work_ += pull * 0.5 * (state.velocity.y[i] + speed) * h;
  }
}

void Grips::clear_loads(model::NodalLoads& loads) const {
  for (const int node : held_) {
    const auto i = static_cast<std::size_t>(node);
    loads.force.set(i, {0, 0, 0});
    loads.moment.set(i, {0, 0, 0});
  }
  for (const int node : driven_) {
    const auto i = static_cast<std::size_t>(node);
    loads.force.y[i] = 0;
    if (test_.grips == model::Grips::clamped) loads.force.set(i, {0, 0, 0});
    loads.moment.set(i, {0, 0, 0});
  }
}

}  // namespace knitmech::solve
