#pragma once

#include <random>

#include "../../support/beam_case.h"
#include "../../support/yarn_shape.h"
#include "contact/yarn_ties.h"
#include "model/model.h"

namespace knitmech::test {

inline constexpr double kTieStiffness = 32;  // N/mm

inline Eigen::Vector3d random_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  return {x, y, normal(random)};
}

/// Two curved yarns of unequal elements that pass each other at a distance of 0.3 mm, tied at two places that lie
/// anywhere on their elements; the second tie shares an element with the first.
inline model::Model tied_yarns(model::Centreline centreline) {
  model::Model model;
  model.sections = {section(19.2265, 6.17, 0.0173039, 0.0124488, 1.29e-11, 0.12)};
  model.centreline = centreline;
  const auto arc = [](double s) {
    return Place{{1.5 * std::sin(s / 1.5), 1.5 * std::cos(s / 1.5) - 1.5, 0},
                 {std::cos(s / 1.5), -std::sin(s / 1.5), 0}};
  };
  const Helix helix{0.8, 1.2};
  const auto above = [&](double s) {
    Place place = helix.at(s);
    place.position += Eigen::Vector3d(0.2, -0.9, 0.3);
    return place;
  };
  add_yarn(model, along(arc, 2.4, 4));
  add_yarn(model, along(above, 2.1, 3));
  model.ties = {{{1, 0.3}, {6, 0.85}}, {{2, 0.0}, {6, 0.4}}};
  model.tie_stiffness = kTieStiffness;
  return model;
}

/// Ties with the line that they see.
struct Tied {
  model::Model model;
  contact::Centreline line;
  contact::YarnTies ties;

  explicit Tied(const model::Model& of) : model(of), line(model), ties(model) {}

  model::NodalLoads loads(const model::State& state) {
    model::NodalLoads loads(model.nodes.size());
    line.update(state, {}, 0);
    ties.add_forces(line, state, loads);
    return loads;
  }
  double energy(const model::State& state) {
    (void)loads(state);
    return ties.energy();
  }
};

/// Every node moved [mm] and turned [rad] at random, by this much on average.
inline model::State deformed(const model::Model& model, std::mt19937& random, double move, double angle) {
  model::State state = state_of(model);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Eigen::Vector3d shift = move * random_vector(random);
    state.position.add(i, {shift.x(), shift.y(), shift.z()});
    set_rotation(state, i, turn(angle * random_vector(random)));
  }
  return state;
}

/// A node moved (axis 0 to 2) or turned (3 to 5) by a little.
inline model::State nudged(model::State state, std::size_t node, int axis, double by) {
  const Eigen::Vector3d motion = by * Eigen::Vector3d::Unit(axis % 3);
  if (axis < 3) {
    state.position.add(node, {motion.x(), motion.y(), motion.z()});
  } else {
    set_rotation(state, node, turn(motion) * rotation_of(state, node));
  }
  return state;
}

/// The whole of a state turned about the origin and moved.
inline model::State moved_rigidly(model::State state, const Eigen::Quaterniond& rotation, const Eigen::Vector3d& by) {
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const Eigen::Vector3d place = rotation * vector_at(state.position, i) + by;
    state.position.set(i, {place.x(), place.y(), place.z()});
    set_rotation(state, i, rotation * rotation_of(state, i));
  }
  return state;
}

}  // namespace knitmech::test
