#include "schemes/static_fabric.h"

#include <algorithm>
#include <cmath>

namespace knitmech::bench {

namespace {

double sum_of_squares(const model::VectorArray& vectors) {
  double sum = 0;
  for (std::size_t i = 0; i < vectors.size(); ++i) sum += dot(vectors.at(i), vectors.at(i));
  return sum;
}

double sum_along(const std::vector<int>& nodes, const model::NodalLoads& loads) {
  double sum = 0;
  for (const int node : nodes) sum += loads.force.y[static_cast<std::size_t>(node)];
  return sum;
}

}  // namespace

StaticFabric::StaticFabric(const model::Model& model)
    : model_(model), elements_(beam::make_elements(model, 1, 0)), work_(model.nodes.size()), grips_(model) {
  const auto [low, high] = std::minmax_element(model.nodes.begin(), model.nodes.end(),
                                               [](const auto& a, const auto& b) { return a.y() < b.y(); });
  for (const Eigen::Vector3d& node : model.nodes) share_.push_back((node.y() - low->y()) / (high->y() - low->y()));
  for (const int node : model.node_sets.at(model.test.held_set)) share_[static_cast<std::size_t>(node)] = 0;
  for (const int node : model.node_sets.at(model.test.driven_set)) share_[static_cast<std::size_t>(node)] = 1;
  for (const model::ModelYarn& yarn : model.yarns) {
    element_length_ += model.arc_length[static_cast<std::size_t>(yarn.first_node + yarn.n_nodes - 1)];
  }
  element_length_ /= model.n_elements();
  const int wales = 1 + *std::ranges::max_element(model.wale);
  least_force_ = wales * model.sections.front().bending_stiffness / std::pow(model.half_stitch_length, 2);
  smallest_radius_ = 0.5 * std::ranges::min(model.sections, {}, &yarn::Section::diameter).diameter;
}

void StaticFabric::set_loads(const model::State& state, double motion, contact::YarnContact& contact,
                             model::NodalLoads& loads) {
  beam::set_internal_force(elements_, state, 0, work_, loads);
  contact.add_forces(state, motion, loads);
  ++evaluations_;
}

void StaticFabric::stretch(double displacement, double time, model::State& state) const {
  const std::size_t n = state.position.size();
  state.velocity = model::VectorArray(n);
  state.angular_velocity = model::VectorArray(n);
  for (std::size_t i = 0; i < n; ++i) {
    state.position.y[i] += share_[i] * displacement;
    state.velocity.y[i] = share_[i] * displacement / time;
  }
}

model::NodalLoads StaticFabric::free_loads(const model::NodalLoads& loads) const {
  model::NodalLoads free = loads;
  grips_.clear_loads(free);
  return free;
}

double StaticFabric::residual(const model::NodalLoads& loads) const {
  const model::NodalLoads free = free_loads(loads);
  return std::sqrt(sum_of_squares(free.force) + sum_of_squares(free.moment) / std::pow(element_length_, 2));
}

double StaticFabric::grip_force(const model::NodalLoads& loads) const {
  const model::TensileTest& test = model_.test;
  return 0.5 * (sum_along(model_.node_sets.at(test.held_set), loads) -
                sum_along(model_.node_sets.at(test.driven_set), loads));
}

bool StaticFabric::is_at_rest(const model::NodalLoads& loads, double tolerance) const {
  return residual(loads) <= tolerance * std::max(grip_force(loads), least_force_);
}

}  // namespace knitmech::bench
