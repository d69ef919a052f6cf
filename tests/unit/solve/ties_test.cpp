#include "solve/ties.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../../support/beam_case.h"
#include "../../support/monofilament.h"
#include "beam/internal_force.h"

namespace knitmech {
namespace {

using Eigen::Vector3d;

constexpr double kApart = 0.13;  // distance of the two centrelines at the tie [mm]

/// Two yarns that cross at a right angle and are tied off their nodes, in free flight.
struct TiedCross {
  model::Model model;
  beam::Elements elements;
  beam::NodalInertia inertia;
  contact::Centreline line;
  solve::Ties ties;
  model::State state;
  model::NodalLoads loads;
  beam::ElementWork work;
  double step;

  static model::Model cross(model::Centreline centreline, bool is_tied) {
    model::Model model = test::yarns_through({test::straight({-2, 0, 0}, {2, 0, 0}, 8),  //
                                              test::straight({0.2, -2, kApart}, {0.2, 2, kApart}, 8)},
                                             test::monofilament());
    model.centreline = centreline;
    model.node_sets[model.test.held_set] = {};
    model.node_sets[model.test.driven_set] = {};
    if (is_tied) model.ties = {{{4, 0.4}, {9 + 3, 1.0}}};
    return model;
  }

  explicit TiedCross(model::Centreline centreline, bool is_tied = true)
      : model(cross(centreline, is_tied)),
        elements(beam::make_elements(model, 1.0, 0.0)),
        inertia(beam::lump_inertia(elements, 1.0)),
        line(model),
        ties(model),
        state(test::state_of(model)),
        loads(model.nodes.size()),
        work(model.nodes.size()),
        step(0.5 * 2 / std::sqrt(inertia.highest_frequency_squared)) {}

  void set_forces() {
    line.update(state, {}, step);
    beam::set_internal_force(elements, state, step, work, loads);
  }
  void advance() {
    set_forces();
    ties.apply(line, inertia, {step, step}, 0, state, loads);
    solve::integrate(inertia, loads, {step, step}, 0, state);
  }
  [[nodiscard]] double energy() {
    set_forces();
    ties.add_last_forces(loads);
    return beam::strain_energy(elements, state) + solve::kinetic_energy(inertia, loads, {step, step}, state);
  }
  /// The first yarn flies up through the second, and each end in another direction.
  void throw_apart() {
    for (std::size_t i = 0; i < 9; ++i) {
      const double s = static_cast<double>(i) / 8;
      state.velocity.set(i, {0, 1e3 * std::sin(5 * s), -2e4 + 1e4 * s});
    }
  }
};

class OnEachCentreline : public testing::TestWithParam<model::Centreline> {};
INSTANTIATE_TEST_SUITE_P(Ties, OnEachCentreline, testing::Values(model::Centreline::smooth, model::Centreline::chords));

TEST_P(OnEachCentreline, GivenYarnsThrownApart_ThenTheTiedPointsStayTogetherAndNoEnergyIsGained) {
  TiedCross cross(GetParam());
  cross.throw_apart();
  cross.advance();
  const double before = cross.energy();
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    cross.advance();
    largest = std::max(largest, cross.ties.largest_stretch());
  }
  // The yarns alone would have flown 100 mm apart by now.
  EXPECT_LT(largest, 0.01 * kApart);
  // Taking back what motion along arcs has left between the points may cost energy in so wild a motion, never give any.
  EXPECT_LT(cross.energy(), 1.001 * before);
  EXPECT_GT(cross.energy(), 0.97 * before);
}

TEST_P(OnEachCentreline, GivenYarnsWithoutTheTie_ThenTheyFlyApart) {
  TiedCross loose(GetParam(), false);
  loose.throw_apart();
  for (int i = 0; i < 20000; ++i) loose.advance();
  EXPECT_GT((test::vector_at(loose.state.position, 4) - test::vector_at(loose.state.position, 13)).norm(), 10);
}

TEST_P(OnEachCentreline, GivenALoadedTie_ThenItsForcesAndMomentsAreInBalance) {
  TiedCross cross(GetParam());
  cross.throw_apart();
  for (int i = 0; i < 100; ++i) cross.advance();
  cross.set_forces();
  cross.ties.apply(cross.line, cross.inertia, {cross.step, cross.step}, 0, cross.state, cross.loads);
  model::NodalLoads by_tie(cross.model.nodes.size());
  cross.ties.add_last_forces(by_tie);
  Vector3d force = Vector3d::Zero();
  Vector3d moment = Vector3d::Zero();
  double size = 0;
  for (std::size_t i = 0; i < cross.model.nodes.size(); ++i) {
    const Vector3d on_node = test::vector_at(by_tie.force, i);
    force += on_node;
    moment += test::vector_at(by_tie.moment, i) + test::vector_at(cross.state.position, i).cross(on_node);
    size += on_node.norm();
  }
  EXPECT_GT(size, 1e-3);
  EXPECT_LT(force.norm(), 1e-12 * size);
  // The two points are one but for the stretch, which is the arm that is left.
  EXPECT_LT(moment.norm(), (1e-12 + cross.ties.largest_stretch()) * size);
}

TEST_P(OnEachCentreline, GivenATiedPairThatIsTurnedAsAWhole_ThenTheTieHasNoForce) {
  TiedCross cross(GetParam());
  const Eigen::Quaterniond rotation = test::turn({1.2, -0.7, 2.0});
  for (std::size_t i = 0; i < cross.model.nodes.size(); ++i) {
    const Vector3d moved = rotation * cross.model.nodes[i] + Vector3d(30, -20, 10);
    cross.state.position.set(i, {moved.x(), moved.y(), moved.z()});
    test::set_rotation(cross.state, i, rotation);
  }
  cross.set_forces();
  cross.ties.apply(cross.line, cross.inertia, {cross.step, cross.step}, 0, cross.state, cross.loads);
  EXPECT_LT(cross.ties.largest_stretch(), 1e-13);
}

}  // namespace
}  // namespace knitmech
