#include "solve/even_stretch.h"

#include <algorithm>

namespace knitmech::solve {

EvenStretch::EvenStretch(const model::Model& model, const beam::NodalInertia& inertia)
    : mass_of_(inertia.mass), shared_mass_(model.nodes.size()), gripped_(model.nodes.size()) {
  for (const std::string& grip : {model.test.held_set, model.test.driven_set}) {
    for (const int node : model.node_sets.at(grip)) gripped_[static_cast<std::size_t>(node)] = true;
  }
  const auto [low, high] = std::minmax_element(model.nodes.begin(), model.nodes.end(),
                                               [](const auto& a, const auto& b) { return a.y() < b.y(); });
  for (std::size_t i = 0; i < shared_mass_.size(); ++i) {
    const double share = (model.nodes[i].y() - low->y()) / (high->y() - low->y());
    shared_mass_[i] = share * inertia.mass[i];
    mass_ += inertia.mass[i];
    stretched_mass_ += share * shared_mass_[i];
  }
}

double EvenStretch::momentum(const model::State& state) const {
  double sum = 0;
  for (std::size_t i = 0; i < shared_mass_.size(); ++i) sum += shared_mass_[i] * state.velocity.y[i];
  return sum;
}

/// The velocities are those half a step before; the force itself is what changes them evenly over the step.
void EvenStretch::apply(double speed, double acceleration, double h, const model::State& state,
                        model::NodalLoads& loads) {
  if (acceleration == 0) return;
  work_ += acceleration * h * (momentum(state) + 0.5 * h * acceleration * stretched_mass_);
  for (std::size_t i = 0; i < shared_mass_.size(); ++i) loads.force.y[i] += acceleration * shared_mass_[i];
  if (acceleration < 0) calm(speed, -acceleration / speed, h, state, loads);
}

/// Work of a step is force times the mean of the velocities before and after it, as far as these are known before the
/// grips have said theirs; gripped nodes have no stray motion to lose.
void EvenStretch::calm(double speed, double rate, double h, const model::State& state, model::NodalLoads& loads) {
  double lost = 0;
  double shared = 0;
  for (std::size_t i = 0; i < mass_of_.size(); ++i) {
    if (gripped_[i]) continue;
    const double even = shared_mass_[i] / mass_of_[i] * speed;
    const Vector3 v = state.velocity.at(i);
    const Vector3 stray{v.x, v.y - even, v.z};
    const Vector3 force = (-rate * mass_of_[i]) * stray;
    lost -= dot(force, stray + (0.5 * h / mass_of_[i]) * loads.force.at(i));
    shared += force.y * even;
    loads.force.add(i, force);
  }
  damping_loss_ += h * lost;
  work_ += h * shared;
}

double EvenStretch::stray_energy(double kinetic, double speed, const model::State& state) const {
  return std::max(0.0, kinetic - speed * momentum(state) + 0.5 * speed * speed * stretched_mass_);
}

}  // namespace knitmech::solve
