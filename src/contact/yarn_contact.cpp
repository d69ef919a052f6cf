#include "contact/yarn_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/segment_distance.h"
#include "contact/constants.h"
#include "contact/curve_distance.h"

namespace knitmech::contact {

namespace {

/// Least distance of two pieces of centreline [mm].
double distance_of(const Curve& a, const Curve& b) {
  const ClosestPoints at = closest_points(a.start, a.end - a.start, b.start, b.end - b.start);
  return length(closest_on_curves(a, b, at.s, at.t).between);
}

}  // namespace

YarnContact::YarnContact(const model::Model& model)
    : elements_(make_contact_elements(model)),
      centreline_(model, elements_),
      skin_(kSkin * 2 * elements_.largest_radius) {}

void YarnContact::search() {
  std::vector<double> bulges(elements_.n_nodes(), 0.0);
  for (std::size_t i = 0; i < bulges.size(); ++i) {
    if (elements_.is_smooth() && elements_.exists[i] != 0) bulges[i] = bulge(centreline_.curve(elements_, i));
  }
  pairs_ = find_neighbours(elements_, centreline_.position(), bulges, skin_);
  places_.assign(pairs_.size(), {});
  clock_.look_at.assign(pairs_.size(), 0.0);
  searched_at_ = clock_.now;
  ++searches_;
}

void YarnContact::add_forces(const model::State& state, double step, model::NodalLoads& loads) {
  clock_.now += centreline_.update(state);
  if (searches_ == 0 || clock_.now - searched_at_ >= 0.5 * skin_) search();
  if (elements_.is_smooth()) {
    find_smooth_contacts(elements_, pairs_, centreline_, clock_, places_, points_);
  } else {
    find_chord_contacts(elements_, pairs_, centreline_.position(), clock_, points_);
  }
  std::swap(memories_, memories_before_);
  memories_.clear();
  for (const ContactPoint& point : points_) apply(point, state, step, loads);
}

void YarnContact::apply(const ContactPoint& point, const model::State& state, double step, model::NodalLoads& loads) {
  const Vector3 motion = step * (centreline_.velocity(elements_, state, point.second, point.place_second) -
                                 centreline_.velocity(elements_, state, point.first, point.place_first));
  const SlipMemory* before = recall(memories_before_, point);
  if (before == nullptr) {
    before = recall_moved(memories_before_, points_, point);
  } else if (dot(before->normal, point.normal) < 0 && !lost_) {
    const auto piece = static_cast<std::size_t>(point.first);
    lost_ =
        LostCrossing{static_cast<std::int32_t>(elements_.element_of(point.first)),
                     static_cast<std::int32_t>(elements_.element_of(point.second)), centreline_.position().at(piece)};
  }
  const FrictionStep friction = friction_step(point, before, motion, elements_.friction * point.load);
  friction_loss_ += friction.loss;
  memories_.push_back(friction.memory);

  const Vector3 force = point.load * point.normal + friction.force;
  centreline_.spread(elements_, point.second, point.place_second, force, loads);
  centreline_.spread(elements_, point.first, point.place_first, -1.0 * force, loads);
}

double YarnContact::energy() const {
  double energy = 0;
  for (const ContactPoint& point : points_) {
    energy += point.energy;
  }
  for (const SlipMemory& memory : memories_) energy += stick_energy(memory);
  return energy;
}

double YarnContact::largest_penetration() const {
  double largest = 0;
  for (const ContactPoint& point : points_) largest = std::max(largest, point.penetration);
  return largest;
}

double YarnContact::highest_frequency_squared(const std::vector<double>& mass,
                                              const std::vector<double>& rotary) const {
  const std::size_t n = mass.size();
  std::vector<double> row(2 * n, 0.0);  // of the displacements, then of the rotations
  double highest = 0;
  for (const ContactPoint& point : points_) {
    struct Entry {
      std::size_t at;
      double size;  // share of the place that this displacement or rotation makes up, over the root of its inertia
    };
    std::array<Entry, 8> entries{};
    std::size_t filled = 0;
    double sum = 0;
    const auto add = [&](std::size_t at, double weight, double inertia) {
      entries[filled] = {at, std::abs(weight) / std::sqrt(inertia)};
      sum += entries[filled++].size;
    };
    for (const auto& [piece, on_piece] :
         {std::pair{point.first, point.place_first}, {point.second, point.place_second}}) {
      const std::size_t i = elements_.element_of(piece);
      const double place = elements_.place_on_element(piece, on_piece);
      if (elements_.is_smooth()) {
        const HermiteWeights weights = hermite(place);
        const double size = elements_.pieces_per_element * elements_.curve_length[static_cast<std::size_t>(piece)];
        add(i, weights.start, mass[i]);
        add(i + 1, weights.end, mass[i + 1]);
        add(n + i, weights.start_slope * size, rotary[i]);
        add(n + i + 1, weights.end_slope * size, rotary[i + 1]);
      } else {
        add(i, 1 - place, mass[i]);
        add(i + 1, place, mass[i + 1]);
      }
    }
    for (std::size_t k = 0; k < filled; ++k) {
      row[entries[k].at] += point.tangent * entries[k].size * sum;
      highest = std::max(highest, row[entries[k].at]);
    }
  }
  return highest;
}

void YarnContact::set_contact_results(model::Frame& frame) const {
  const std::size_t n = frame.points.size();
  model::NodalLoads loads(n);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const ContactPoint& point = points_[i];
    const Vector3 on_second = point.load * point.normal - memories_[i].stick_stiffness * memories_[i].elastic_slip;
    centreline_.spread(elements_, point.second, point.place_second, on_second, loads);
    centreline_.spread(elements_, point.first, point.place_first, -1.0 * on_second, loads);
  }
  frame.contact_force.resize(n);
  for (std::size_t i = 0; i < n; ++i) frame.contact_force[i] = {loads.force.x[i], loads.force.y[i], loads.force.z[i]};

  frame.gap.assign(n, std::numeric_limits<double>::infinity());
  for (const ElementPair pair : pairs_) {
    const auto a = static_cast<std::size_t>(pair.first);
    const auto b = static_cast<std::size_t>(pair.second);
    const double gap = distance_of(centreline_.curve(elements_, a), centreline_.curve(elements_, b)) -
                       elements_.radius[a] - elements_.radius[b];
    for (const std::int32_t piece : {pair.first, pair.second}) {
      const std::size_t node = elements_.element_of(piece);
      frame.gap[node] = std::min(frame.gap[node], gap);
      frame.gap[node + 1] = std::min(frame.gap[node + 1], gap);
    }
  }
}

}  // namespace knitmech::contact
