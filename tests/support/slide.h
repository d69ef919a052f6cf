#pragma once

#include <algorithm>
#include <limits>

#include "contact_bench.h"
#include "yarn_shape.h"

namespace knitmech::test {

/// Normal force between two yarns [N] while one is moved along the other by hand.
struct SlidingForce {
  double least = std::numeric_limits<double>::max();
  double largest = 0;
  double mean = 0;
  [[nodiscard]] double ripple() const { return (largest - least) / mean; }
};

/// Size of the sum of the contact forces on the second of two stress-free yarns [N], without friction.
inline double force_between(const yarn::Section& section, double stiffness, model::Centreline centreline,
                            const YarnShape& lower, const YarnShape& upper) {
  model::Model model = empty_model(section, 0, stiffness, centreline);
  add_yarn(model, lower);
  add_yarn(model, upper);
  contact::YarnContact contact(model);
  model::NodalLoads loads(model.nodes.size());
  contact.add_forces(state_of(model), 0, loads);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = lower.places.size(); i < model.nodes.size(); ++i) sum += vector_at(loads.force, i);
  return sum.norm();
}

/// The force at places evenly over a stretch. \param force_at of a share of the stretch, in [0, 1)
template <typename ForceAt>
SlidingForce slide(const ForceAt& force_at, int n_places) {
  SlidingForce force;
  for (int i = 0; i < n_places; ++i) {
    const double here = force_at(static_cast<double>(i) / n_places);
    force.least = std::min(force.least, here);
    force.largest = std::max(force.largest, here);
    force.mean += here / n_places;
  }
  return force;
}

}  // namespace knitmech::test
