#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "../../support/beam_case.h"
#include "contact/closest_places.h"
#include "contact/friction.h"

namespace knitmech::contact {

inline constexpr double kRadii = 0.11;         // mm, of yarns of 0.12 and 0.1 mm
inline constexpr double kPlaceError = 0.8e-4;  // -, share by which places are off before the step

/// Two yarns of three elements; the places that are followed lie on the elements in their middles.
struct Scene {
  model::Model model;
  model::State state;
  YarnElements elements;
  Centreline line;
  YarnPlace first, second;
  SlipMemory stick;

  Scene(model::Model of_yarns, model::State at)
      : model(std::move(of_yarns)),
        state(std::move(at)),
        elements(make_yarn_elements(model)),
        line(model),
        first{1, 0.5},
        second{5, 0.5} {
    line.update(state, {}, 0);
  }
};

inline Vector3 noise(std::mt19937& random, double size) {
  std::normal_distribution<double> normal(0, size);
  const double a = normal(random);
  const double b = normal(random);
  return {a, b, normal(random)};
}

inline Eigen::Vector3d eigen(Vector3 v) {
  return {v.x, v.y, v.z};
}

inline model::Model with_two_diameters(const std::vector<std::vector<Eigen::Vector3d>>& yarns) {
  model::Model model = test::yarns_through(yarns, test::section(1, 1, 1, 1, 1, 0.12));
  model.sections.push_back(test::section(1, 1, 1, 1, 1, 0.1));
  std::fill(model.element_section.begin() + model.yarns[1].first_node, model.element_section.end(), 1);
  return model;
}

/// Two bent yarns with bows that cross at an angle of 30 degrees at least.
inline model::Model bent_yarns(std::mt19937& random) {
  std::uniform_real_distribution<double> angles(0.52, 1.57);
  const double angle = angles(random);
  const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
  std::vector<std::vector<Eigen::Vector3d>> yarns(2);
  for (int i = 0; i < 4; ++i) {
    yarns[0].emplace_back((0.5 * i - 0.75) * Eigen::Vector3d::UnitX() + eigen(noise(random, 0.02)));
    yarns[1].emplace_back((0.4 * i - 0.6) * along + Eigen::Vector3d(0, 0, kRadii) + eigen(noise(random, 0.02)));
  }
  model::Model model = with_two_diameters(yarns);
  for (std::size_t i = 0; i < 8; ++i) {
    model.tangents[i] = (model.tangents[i] + eigen(noise(random, 0.1))).normalized();
    model.middles.emplace_back(0.5 * (model.nodes[i] + model.nodes[std::min<std::size_t>(i + 1, 7)]) +
                               eigen(noise(random, 0.005)));
  }
  return model;
}

/// The state of a model with its nodes turned a little, so that the halves of a bow differ.
inline model::State turned_state(const model::Model& model, std::mt19937& random) {
  model::State state = test::state_of(model);
  for (std::size_t i = 0; i < 8; ++i) test::set_rotation(state, i, test::turn(eigen(noise(random, 0.05))));
  return state;
}

/// All nodes of the second yarn are shifted.
inline void shift_second(model::State& state, Vector3 by) {
  for (std::size_t i = 4; i < 8; ++i) state.position.add(i, by);
}

inline Followed follow(const Scene& scene) {
  return follow_closest(scene.elements, scene.line, scene.first, scene.second);
}

inline bool amid_elements(const Followed& here) {
  return here.is_minimum && here.first.element == 1 && here.second.element == 5 &&
         std::abs(here.first.share - 0.5) < 0.4 && std::abs(here.second.share - 0.5) < 0.4;
}

/// The yarns pressed into each other along the line between the places, with velocities and a stick of any size.
inline Scene pressed(const Scene& apart, const Followed& here, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double distance = length(here.at.between);
  const Vector3 normal = (1 / distance) * here.at.between;
  const double penetration = kSmallOverlap * kRadii * (0.1 + 0.89 * uniform(random));
  model::State state = apart.state;
  shift_second(state, (kRadii - penetration - distance) * normal);
  for (std::size_t i = 0; i < 8; ++i) {
    state.velocity.set(i, noise(random, 300));
    state.angular_velocity.set(i, noise(random, 1000));
  }
  Scene scene(apart.model, state);
  scene.first = here.first;
  scene.second = here.second;
  if (uniform(random) < 0.8) {
    scene.stick = {normal + noise(random, 0.01), noise(random, 3e-4 * uniform(random)), 0, false};
  }
  return scene;
}

/// Moves the places off by what one step of Newton's method brings them back.
inline void move_off(Scene& scene, std::mt19937& random) {
  std::uniform_real_distribution<double> error(-kPlaceError, kPlaceError);
  scene.first.share += error(random);
  scene.second.share += error(random);
}

inline Scene random_scene(std::mt19937& random) {
  for (;;) {
    const model::Model model = bent_yarns(random);
    const Scene apart(model, turned_state(model, random));
    const Followed crossing = follow(apart);
    if (!amid_elements(crossing)) continue;
    Scene scene = pressed(apart, crossing, random);
    if (!amid_elements(follow(scene))) continue;
    move_off(scene, random);
    return scene;
  }
}

/// Straight yarns at a right angle, the first along x, the second along y; their places are a share of the way along
/// the elements in their middles, which are 0.5 mm long.
inline Scene straight_scene(double penetration, double first_share = 0.5, double second_share = 0.5) {
  const double x = -0.25 + 0.5 * first_share;
  const double y = 0.25 - 0.5 * second_share;
  const double z = kRadii - penetration;
  const model::Model model = with_two_diameters(
      {test::straight({-0.75, 0, 0}, {0.75, 0, 0}, 3), test::straight({x, y - 0.75, z}, {x, y + 0.75, z}, 3)});
  Scene scene(model, test::state_of(model));
  scene.first.share = first_share;
  scene.second.share = second_share;
  return scene;
}

}  // namespace knitmech::contact
