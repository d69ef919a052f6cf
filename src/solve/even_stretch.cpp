#include "solve/even_stretch.h"

#include <algorithm>

namespace knitmech::solve {

EvenStretch::EvenStretch(const model::Model& model, const beam::NodalInertia& inertia)
    : mass_of_(inertia.mass),
      relative_(inertia.relative_mass),
      shared_mass_(model.nodes.size()),
      gripped_(model.nodes.size()) {
  for (const std::string& grip : {model.test.held_set, model.test.driven_set}) {
    for (const int node : model.node_sets.at(grip)) gripped_[static_cast<std::size_t>(node)] = 1;
  }
  const auto [low, high] = std::minmax_element(model.nodes.begin(), model.nodes.end(),
                                               [](const auto& a, const auto& b) { return a.y() < b.y(); });
  for (const Eigen::Vector3d& node : model.nodes) share_.push_back((node.y() - low->y()) / (high->y() - low->y()));
  for (std::size_t i = 0; i < share_.size(); ++i) {
    shared_mass_[i] = inertia_of(i, [&](std::size_t k) { return share_[k]; });
    mass_ += mass_of_[i];
    stretched_mass_ += share_[i] * shared_mass_[i];
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
  const auto stray_of = [&](std::size_t i) {
    const Vector3 v = state.velocity.at(i);
    return gripped_[i] ? Vector3{0, 0, 0} : Vector3{v.x, v.y - share_[i] * speed, v.z};
  };
  double lost = 0;
  double shared = 0;
  for (std::size_t i = 0; i < mass_of_.size(); ++i) {
    const Vector3 stray = stray_of(i);
    const Vector3 force = -rate * inertia_of(i, stray_of);
    lost += dot(stray, (0.5 * h * rate) * loads.force.at(i) - force);
    shared += force.y * share_[i] * speed;
    loads.force.add(i, force);
  }
  damping_loss_ += h * lost;
  work_ += h * shared;
}

double EvenStretch::stray_energy(double kinetic, double speed, const model::State& state) const {
  return std::max(0.0, kinetic - speed * momentum(state) + 0.5 * speed * speed * stretched_mass_);
}

}  // namespace knitmech::solve
