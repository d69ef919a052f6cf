#include "contact/centreline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "../../support/beam_case.h"
#include "../../support/yarn_shape.h"

namespace knitmech::contact {
namespace {

constexpr double kRadius = 1.1;  // mm, head arc of the main example

/// Straight, then an arc: where a leg runs into a head. The arc starts at a length of 1.7 mm.
test::Place leg_and_head(double s) {
  const double turned = std::max(0.0, s - 1.7) / kRadius;
  const double straight = std::min(s, 1.7);
  return {{straight + kRadius * std::sin(turned), kRadius * (1 - std::cos(turned)), 0.1 * straight},
          Eigen::Vector3d(std::cos(turned), std::sin(turned), s < 1.7 ? 0.1 : 0.0).normalized()};
}

test::Place on_arc(double s) {
  return {{kRadius * std::cos(s / kRadius), kRadius * std::sin(s / kRadius), 0},
          {-std::sin(s / kRadius), std::cos(s / kRadius), 0}};
}

model::Model model_of(const test::YarnShape& shape) {
  model::Model model;
  model.sections = {test::section(19, 6, 0.017, 0.012, 1e-11, 0.12)};
  model.centreline = model::Centreline::smooth;
  test::add_yarn(model, shape);
  return model;
}

struct Line {
  Centreline line;
  std::size_t n_elements;
  explicit Line(const model::Model& model) : line(model), n_elements(model.nodes.size() - 1) {}

  void update(const model::State& state) { line.update(state, {}, 0); }
  [[nodiscard]] Eigen::Vector3d at(std::size_t element, double place) const {
    const Vector3 x = combine(line.curve(element), hermite(place));
    return {x.x, x.y, x.z};
  }
};

/// Every node moved and turned.
model::State deformed(const model::Model& model, std::mt19937& random, double move, double turn) {
  std::normal_distribution<double> normal;
  const auto vector = [&] {
    const double x = normal(random);
    const double y = normal(random);
    return Eigen::Vector3d(x, y, normal(random));
  };
  model::State state = test::state_of(model);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Eigen::Vector3d shift = move * vector();
    state.position.add(i, {shift.x(), shift.y(), shift.z()});
    test::set_rotation(state, i, test::turn(turn * vector()));
  }
  return state;
}

/// Largest distance of the curve from the circle in units of R a^4 / 384, by which cubics with the arc length as that
/// of their slopes leave an arc of the angle a (Taylor expansion of the middle's radius).
double off_the_circle(const test::YarnShape& shape, double angle) {
  const model::Model model = model_of(shape);
  Line line(model);
  line.update(test::state_of(model));
  double farthest = 0;
  for (std::size_t piece = 0; piece < line.n_elements; ++piece) {
    for (int i = 0; i <= 20; ++i) farthest = std::max(farthest, std::abs(line.at(piece, i / 20.0).norm() - kRadius));
  }
  return farthest / (kRadius * std::pow(angle, 4) / 384);
}

TEST(Centreline, GivenAHeadArc_ThenTheBowTakesAwayWhatTheCubicLacks) {
  const double angle = 0.8;
  test::YarnShape shape = test::along(on_arc, 5 * angle * kRadius, 5);
  EXPECT_LT(off_the_circle(shape, angle), 0.03);
  shape.middles.clear();
  EXPECT_NEAR(off_the_circle(shape, angle), 1, 0.05);
}

TEST(Centreline, GivenAnElementAcrossTheEndOfAnArc_ThenTheCurveGoesThroughTheTrueMiddle) {
  // Given five elements of 0.8 mm, the arc begins in the third.
  const model::Model model = model_of(test::along(leg_and_head, 4.0, 5));
  Line line(model);
  line.update(test::state_of(model));
  for (std::size_t element = 0; element < 5; ++element) {
    EXPECT_LT((line.at(element, 0.5) - model.middles[element]).norm(), 1e-14) << "element " << element;
  }
}

TEST(Centreline, GivenAYarnThatIsMovedRigidly_ThenTheCurveMovesWithIt) {
  const model::Model model = model_of(test::along(leg_and_head, 4.0, 5));
  Line before(model);
  Line after(model);
  const model::State start = test::state_of(model);
  model::State moved = start;
  const Eigen::Quaterniond rotation = test::turn({0.7, -1.9, 0.4});
  const Eigen::Vector3d shift(3, -2, 5);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Eigen::Vector3d at = rotation * model.nodes[i] + shift;
    moved.position.set(i, {at.x(), at.y(), at.z()});
    test::set_rotation(moved, i, rotation);
  }
  before.update(start);
  after.update(moved);
  for (std::size_t piece = 0; piece < before.n_elements; ++piece) {
    for (const double place : {0.0, 0.3, 0.8}) {
      EXPECT_LT((after.at(piece, place) - rotation * before.at(piece, place) - shift).norm(), 1e-13);
    }
  }
}

TEST(Centreline, GivenMovingNodes_ThenVelocitiesAreTheDerivativesOfPlacesAndForcesDoTheirWork) {
  std::mt19937 random(43);
  std::normal_distribution<double> normal;
  const model::Model model = model_of(test::along(leg_and_head, 4.0, 5));
  model::State state = deformed(model, random, 0.1, 0.3);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const std::array<double, 6> v = {normal(random), normal(random), normal(random),
                                     normal(random), normal(random), normal(random)};
    state.velocity.set(i, {v[0], v[1], v[2]});
    state.angular_velocity.set(i, {v[3], v[4], v[5]});
  }
  const double h = 1e-6;
  const auto later = [&](double time) {
    model::State then = state;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      then.position.add(i, time * state.velocity.at(i));
      const Eigen::Vector3d turned = time * test::vector_at(state.angular_velocity, i);
      test::set_rotation(then, i, test::turn(turned) * test::rotation_of(state, i));
    }
    Line line(model);
    line.update(then);
    return line;
  };
  const Line before = later(-h);
  const Line now = later(0);
  const Line after = later(h);
  const Vector3 force{0.3, -0.7, 0.5};
  for (std::size_t piece = 0; piece < now.n_elements; ++piece) {
    for (const double place : {0.1, 0.5, 0.9}) {
      const Eigen::Vector3d expected = (after.at(piece, place) - before.at(piece, place)) / (2 * h);
      const YarnPlace at{static_cast<std::int32_t>(piece), place};
      const Vector3 velocity = now.line.velocity(state, at);
      EXPECT_LT((Eigen::Vector3d(velocity.x, velocity.y, velocity.z) - expected).norm(), 1e-8);

      model::NodalLoads loads(model.nodes.size());
      now.line.spread(at, force, loads);
      double power = 0;
      for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        power += dot(loads.force.at(i), state.velocity.at(i)) + dot(loads.moment.at(i), state.angular_velocity.at(i));
      }
      EXPECT_NEAR(power, dot(force, velocity), 1e-13);
    }
  }
}

TEST(Centreline, GivenLoadsOnSlopeAndBend_ThenTheyDoTheWorkOfTheCurvesChange) {
  std::mt19937 random(53);
  const model::Model model = model_of(test::along(leg_and_head, 4.0, 5));
  const model::State state = deformed(model, random, 0.1, 0.3);
  const CurveLoad load{{0.3, -0.7, 0.5}, {-0.2, 0.4, 0.1}, {0.05, 0.02, -0.03}};
  const double place = 0.37;
  const auto work_done = [&](const model::State& then, std::size_t element) {
    Line line(model);
    line.update(then);
    const CurvePoint at = point_at(line.line.curve(element), place);
    return dot(load.force, at.position) + dot(load.slope, at.slope) + dot(load.bend, at.bend);
  };
  constexpr double kStep = 1e-6;
  for (std::size_t element = 0; element < 5; ++element) {
    Line line(model);
    line.update(state);
    model::NodalLoads loads(model.nodes.size());
    line.line.spread({static_cast<std::int32_t>(element), place}, load, loads);
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d along = kStep * Eigen::Vector3d::Unit(axis);
        std::array<double, 2> moved{};
        std::array<double, 2> turned{};
        for (const int side : {0, 1}) {
          const Eigen::Vector3d step = side == 0 ? along : Eigen::Vector3d(-along);
          model::State then = state;
          then.position.add(node, {step.x(), step.y(), step.z()});
          moved.at(static_cast<std::size_t>(side)) = work_done(then, element);
          then = state;
          test::set_rotation(then, node, test::turn(step) * test::rotation_of(state, node));
          turned.at(static_cast<std::size_t>(side)) = work_done(then, element);
        }
        EXPECT_NEAR(test::vector_at(loads.force, node)[axis], (moved[0] - moved[1]) / (2 * kStep), 1e-8);
        EXPECT_NEAR(test::vector_at(loads.moment, node)[axis], (turned[0] - turned[1]) / (2 * kStep), 1e-8);
      }
    }
  }
}

TEST(Centreline, GivenRandomMotions_ThenNoPointMovesFartherThanTheNodesOfItsElementSay) {
  std::mt19937 random(47);
  const model::Model model = model_of(test::along(leg_and_head, 4.0, 5));
  Line line(model);
  line.update(test::state_of(model));
  for (int trial = 0; trial < 200; ++trial) {
    const Line before = line;
    line.update(deformed(model, random, trial % 2 == 0 ? 0.0 : 0.02, 0.1));
    for (std::size_t piece = 0; piece < line.n_elements; ++piece) {
      const double moved = std::max(line.line.moved()[piece], line.line.moved()[piece + 1]);
      for (int i = 0; i <= 4; ++i) {
        EXPECT_LE((line.at(piece, i / 4.0) - before.at(piece, i / 4.0)).norm(), moved + 1e-14);
      }
    }
  }
}

TEST(Curve, GivenAStepAlongIt_ThenPlaceAndDerivativesFollowExactlyAndAPartIsTheSameLine) {
  const Curve curve{{0, 0, 0}, {1, 0.2, 0}, {1, 0.5, -0.3}, {0.8, -0.6, 0.4}, {0.05, 0.02, -0.04}};
  for (const double step : {-0.2, 1e-4, 0.3}) {
    const CurvePoint there = point_at(curve, 0.4 + step);
    const CurvePoint followed = shifted(point_at(curve, 0.4), step);
    EXPECT_LT(length(there.position - followed.position), 1e-15);
    EXPECT_LT(length(there.slope - followed.slope), 1e-14);
    EXPECT_LT(length(there.bend - followed.bend), 1e-13);
    EXPECT_LT(length(there.jerk - followed.jerk), 1e-13);
  }
  const CurvePoint at = point_at(curve, 0.4);
  EXPECT_LT(length(at.position - combine(curve, hermite(0.4))), 1e-15);
  EXPECT_LT(length(at.slope - combine(curve, hermite_slope(0.4))), 1e-14);
  EXPECT_LT(length(at.bend - combine(curve, hermite_bend(0.4))), 1e-14);
  const Curve part = part_of(curve, 0.25, 0.75);
  for (const double s : {0.0, 0.2, 0.9}) {
    EXPECT_LT(length(combine(part, hermite(s)) - combine(curve, hermite(0.25 + 0.5 * s))), 1e-15);
  }
}

}  // namespace
}  // namespace knitmech::contact
