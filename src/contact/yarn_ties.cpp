#include "contact/yarn_ties.h"

#include <algorithm>

#include "contact/frequency_bound.h"

namespace knitmech::contact {

namespace {

Vector3 turned(const model::State& state, std::size_t node, Vector3 arm) {
  const model::RotationArray& q = state.rotation;
  const Vector3 v{q.x[node], q.y[node], q.z[node]};
  const Vector3 twice = 2.0 * cross(v, arm);
  return arm + q.w[node] * twice + cross(v, twice);
}

model::State stress_free(const model::Model& model) {
  model::State state(model.nodes.size());
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    state.position.set(i, {model.nodes[i].x(), model.nodes[i].y(), model.nodes[i].z()});
  }
  return state;
}

std::size_t nearest_node(YarnPlace place) {
  return static_cast<std::size_t>(place.element) + (place.share > 0.5 ? 1 : 0);
}

}  // namespace

YarnTies::YarnTies(const model::Model& model) : stiffness_(model.tie_stiffness) {
  if (model.ties.empty()) return;
  Centreline line(model);
  line.update(stress_free(model), {}, 0);
  for (const model::Tie& tie : model.ties) {
    const Vector3 between = line.point(tie.second) - line.point(tie.first);
    pairs_.push_back(
        {{tie.first, nearest_node(tie.first), 0.5 * between}, {tie.second, nearest_node(tie.second), -0.5 * between}});
  }
}

void YarnTies::add_forces(const Centreline& line, const model::State& state, model::NodalLoads& loads) {
  for (Pair& pair : pairs_) {
    const Vector3 first_arm = turned(state, pair.first.node, pair.first.arm);
    const Vector3 second_arm = turned(state, pair.second.node, pair.second.arm);
    const Vector3 apart = line.point(pair.second.place) + second_arm - line.point(pair.first.place) - first_arm;
    pair.force = stiffness_ * apart;
    line.spread(pair.first.place, pair.force, loads);
    line.spread(pair.second.place, -1.0 * pair.force, loads);
    loads.moment.add(pair.first.node, cross(first_arm, pair.force));
    loads.moment.add(pair.second.node, -1.0 * cross(second_arm, pair.force));
  }
}

double YarnTies::energy() const {
  double energy = 0;
  for (const Pair& pair : pairs_) energy += 0.5 * dot(pair.force, pair.force) / stiffness_;
  return energy;
}

double YarnTies::largest_stretch() const {
  double largest = 0;
  for (const Pair& pair : pairs_) largest = std::max(largest, length(pair.force) / stiffness_);
  return largest;
}

double YarnTies::highest_frequency_squared(const Centreline& line, const std::vector<double>& mass,
                                           const std::vector<double>& rotary) const {
  FrequencyBound bound(mass, rotary);
  const auto end_of = [&](const Anchor& anchor) {
    return FrequencyBound::End{anchor.place, line.hold(anchor.place), anchor.node, length(anchor.arm)};
  };
  for (const Pair& pair : pairs_) bound.add(end_of(pair.first), end_of(pair.second), stiffness_);
  return bound.highest();
}

void YarnTies::set_results(const Centreline& line, model::Frame& frame) const {
  model::NodalLoads loads(frame.points.size());
  for (const Pair& pair : pairs_) {
    line.spread(pair.first.place, pair.force, loads);
    line.spread(pair.second.place, -1.0 * pair.force, loads);
  }
  frame.tie_force.resize(loads.force.size());
  for (std::size_t i = 0; i < loads.force.size(); ++i) {
    frame.tie_force[i] = {loads.force.x[i], loads.force.y[i], loads.force.z[i]};
  }
}

}  // namespace knitmech::contact
