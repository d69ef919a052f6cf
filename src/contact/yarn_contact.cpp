#include "contact/yarn_contact.h"

#include <algorithm>
#include <limits>

#include "base/segment_distance.h"
#include "contact/constants.h"
#include "contact/normal_law.h"

namespace knitmech::contact {

namespace {

Vector3 interpolate(const model::VectorArray& field, std::int32_t element, double place) {
  const auto i = static_cast<std::size_t>(element);
  return (1 - place) * field.at(i) + place * field.at(i + 1);
}

/// A force at a place of an element goes to its nodes by the same weights that gave the place.
void spread(model::VectorArray& nodal, std::int32_t element, double place, Vector3 force) {
  const auto i = static_cast<std::size_t>(element);
  nodal.add(i, (1 - place) * force);
  nodal.add(i + 1, place * force);
}

KNITMECH_VECTORISE double largest_move_squared(const double* x, const double* y, const double* z, const double* x0,
                                               const double* y0, const double* z0, std::size_t n) {
  double largest = 0;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = x[i] - x0[i];
    const double dy = y[i] - y0[i];
    const double dz = z[i] - z0[i];
    const double squared = dx * dx + dy * dy + dz * dz;
    largest = largest > squared ? largest : squared;
  }
  return largest;
}

}  // namespace

ContactElements make_contact_elements(const model::Model& model) {
  const std::size_t n = model.nodes.size();
  ContactElements elements;
  elements.yarn.assign(n, 0);
  elements.exists.assign(n, 0);
  elements.radius.assign(n, 0.0);
  elements.rest_length.assign(n, 0.0);
  elements.arc_length = model.arc_length;
  elements.friction = model.friction;
  elements.stiffness = model.contact_stiffness;
  for (std::size_t y = 0; y < model.yarns.size(); ++y) {
    const model::ModelYarn& yarn = model.yarns[y];
    const double radius = 0.5 * model.sections[static_cast<std::size_t>(yarn.section)].diameter;
    elements.largest_radius = std::max(elements.largest_radius, radius);
    const auto first = static_cast<std::size_t>(yarn.first_node);
    const auto end = first + static_cast<std::size_t>(yarn.n_nodes);
    for (std::size_t i = first; i < end; ++i) {
      elements.yarn[i] = static_cast<std::int32_t>(y);
      elements.radius[i] = radius;
      if (i + 1 == end) continue;
      elements.exists[i] = 1;
      elements.rest_length[i] = (model.nodes[i + 1] - model.nodes[i]).norm();
    }
  }
  return elements;
}

YarnContact::YarnContact(ContactElements elements)
    : elements_(std::move(elements)), skin_(kSkin * 2 * elements_.largest_radius) {}

void YarnContact::search_if_moved(const model::VectorArray& position) {
  if (searched_at_.size() == position.size()) {
    const double moved =
        largest_move_squared(position.x.data(), position.y.data(), position.z.data(), searched_at_.x.data(),
                             searched_at_.y.data(), searched_at_.z.data(), position.size());
    if (moved < 0.25 * skin_ * skin_) return;
  }
  pairs_ = find_neighbours(elements_, position, skin_);
  searched_at_ = position;
  ++searches_;
}

void YarnContact::add_forces(const model::State& state, double step, model::NodalLoads& loads) {
  search_if_moved(state.position);
  find_contact_points(elements_, pairs_, state.position, points_);
  std::swap(memories_, memories_before_);
  memories_.clear();
  for (const ContactPoint& point : points_) apply(point, state, step, loads);
}

void YarnContact::apply(const ContactPoint& point, const model::State& state, double step, model::NodalLoads& loads) {
  const double normal_load = point.stiffness * normal_force(point.penetration, point.radii);
  const Vector3 motion = step * (interpolate(state.velocity, point.second, point.place_second) -
                                 interpolate(state.velocity, point.first, point.place_first));
  const SlipMemory* before = recall(memories_before_, point);
  if (before == nullptr) {
    before = recall_moved(memories_before_, points_, point);
  } else if (dot(before->normal, point.normal) < 0 && !lost_) {
    lost_ = LostCrossing{point.first, point.second, interpolate(state.position, point.first, point.place_first)};
  }
  const FrictionStep friction = friction_step(point, before, motion, elements_.friction * normal_load);
  friction_loss_ += friction.loss;
  memories_.push_back(friction.memory);

  const Vector3 force = normal_load * point.normal + friction.force;
  spread(loads.force, point.second, point.place_second, force);
  spread(loads.force, point.first, point.place_first, -1.0 * force);
}

double YarnContact::energy() const {
  double energy = 0;
  for (const ContactPoint& point : points_) {
    energy += point.stiffness * normal_energy(point.penetration, point.radii);
  }
  for (const SlipMemory& memory : memories_) energy += stick_energy(memory);
  return energy;
}

double YarnContact::largest_penetration() const {
  double largest = 0;
  for (const ContactPoint& point : points_) largest = std::max(largest, point.penetration);
  return largest;
}

double YarnContact::highest_frequency_squared(const std::vector<double>& mass) const {
  std::vector<double> row(mass.size(), 0.0);
  double highest = 0;
  for (const ContactPoint& point : points_) {
    const double twice = 2 * point.stiffness * normal_tangent(point.penetration, point.radii);
    const auto a = static_cast<std::size_t>(point.first);
    const auto b = static_cast<std::size_t>(point.second);
    row[a] += twice * (1 - point.place_first);
    row[a + 1] += twice * point.place_first;
    row[b] += twice * (1 - point.place_second);
    row[b + 1] += twice * point.place_second;
    for (const std::size_t node : {a, a + 1, b, b + 1}) highest = std::max(highest, row[node] / mass[node]);
  }
  return highest;
}

void YarnContact::set_contact_results(const model::State& state, model::Frame& frame) const {
  const std::size_t n = elements_.n_nodes();
  model::VectorArray force(n);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const ContactPoint& point = points_[i];
    const double normal_load = point.stiffness * normal_force(point.penetration, point.radii);
    const Vector3 on_second = normal_load * point.normal - memories_[i].stick_stiffness * memories_[i].elastic_slip;
    spread(force, point.second, point.place_second, on_second);
    spread(force, point.first, point.place_first, -1.0 * on_second);
  }
  frame.contact_force.resize(n);
  for (std::size_t i = 0; i < n; ++i) frame.contact_force[i] = {force.x[i], force.y[i], force.z[i]};

  frame.gap.assign(n, std::numeric_limits<double>::infinity());
  for (const ElementPair pair : pairs_) {
    const auto a = static_cast<std::size_t>(pair.first);
    const auto b = static_cast<std::size_t>(pair.second);
    const Vector3 u = state.position.at(a + 1) - state.position.at(a);
    const Vector3 v = state.position.at(b + 1) - state.position.at(b);
    const ClosestPoints at = closest_points(state.position.at(a), u, state.position.at(b), v);
    const Vector3 between = state.position.at(b) + at.t * v - state.position.at(a) - at.s * u;
    const double gap = length(between) - elements_.radius[a] - elements_.radius[b];
    for (const std::size_t node : {a, a + 1, b, b + 1}) frame.gap[node] = std::min(frame.gap[node], gap);
  }
}

}  // namespace knitmech::contact
