#include "contact/yarn_ties.h"

#include <gtest/gtest.h>

#include <random>

#include "../../support/centrelines.h"
#include "tied_yarns.h"

namespace knitmech {
namespace {

using Eigen::Vector3d;
using test::Tied;
using test::vector_at;

class YarnTiesOn : public testing::TestWithParam<model::Centreline> {
 protected:
  Tied tied_{test::tied_yarns(GetParam())};
  std::mt19937 random_{17};
};
KNITMECH_WITH_EVERY_CENTRELINE(YarnTiesOn);

TEST_P(YarnTiesOn, GivenTheYarnsAsTheyWereTied_ThenThereIsNoForce) {
  const model::NodalLoads loads = tied_.loads(test::state_of(tied_.model));
  for (std::size_t i = 0; i < tied_.model.nodes.size(); ++i) {
    EXPECT_LT(vector_at(loads.force, i).norm(), 1e-13);
    EXPECT_LT(vector_at(loads.moment, i).norm(), 1e-13);
  }
  EXPECT_LT(tied_.ties.largest_stretch(), 1e-15);
}

TEST_P(YarnTiesOn, GivenRandomStatesWithLargeRotations_ThenTheLoadsAreTheNegativeDerivativeOfTheEnergy) {
  const double h = 1e-5;  // [mm] or [rad]; the central difference is off by h^2
  for (int trial = 0; trial < 100; ++trial) {
    const model::State state = test::deformed(tied_.model, random_, 0.3, 1.0);
    const model::NodalLoads loads = tied_.loads(state);
    const double scale = tied_.ties.energy();
    for (std::size_t node = 0; node < tied_.model.nodes.size(); ++node) {
      for (int axis = 0; axis < 6; ++axis) {
        const double slope =
            (tied_.energy(test::nudged(state, node, axis, h)) - tied_.energy(test::nudged(state, node, axis, -h))) /
            (2 * h);
        const double load = axis < 3 ? vector_at(loads.force, node)[axis] : vector_at(loads.moment, node)[axis - 3];
        ASSERT_NEAR(load, -slope, 1e-7 * scale) << "trial " << trial << ", node " << node << ", axis " << axis;
      }
    }
  }
}

TEST_P(YarnTiesOn, GivenAnyState_ThenForcesAndMomentsAreInBalance) {
  for (int trial = 0; trial < 100; ++trial) {
    const model::State state = test::deformed(tied_.model, random_, 0.3, 1.0);
    const model::NodalLoads loads = tied_.loads(state);
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for (std::size_t i = 0; i < tied_.model.nodes.size(); ++i) {
      force += vector_at(loads.force, i);
      moment += vector_at(loads.moment, i) + vector_at(state.position, i).cross(vector_at(loads.force, i));
    }
    const double pull = test::kTieStiffness * tied_.ties.largest_stretch();
    EXPECT_LT(force.norm(), 1e-13 * pull);
    EXPECT_LT(moment.norm(), 1e-12 * pull);
  }
}

TEST_P(YarnTiesOn, GivenARigidMotionWithAnyRotation_ThenThereIsNoForce) {
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Quaterniond rotation = test::turn(3 * test::random_vector(random_));
    const model::State state =
        test::moved_rigidly(test::state_of(tied_.model), rotation, 50 * test::random_vector(random_));
    const model::NodalLoads loads = tied_.loads(state);
    for (std::size_t i = 0; i < tied_.model.nodes.size(); ++i) EXPECT_LT(vector_at(loads.force, i).norm(), 1e-11);
  }
}

TEST_P(YarnTiesOn, GivenADeformedStateThatIsMovedRigidly_ThenTheLoadsTurnWithItAndTheEnergyStays) {
  for (int trial = 0; trial < 100; ++trial) {
    const model::State before = test::deformed(tied_.model, random_, 0.3, 1.0);
    const Eigen::Quaterniond rotation = test::turn(3 * test::random_vector(random_));
    const model::State after = test::moved_rigidly(before, rotation, {4, -7, 2});
    const model::NodalLoads loads_before = tied_.loads(before);
    const double energy = tied_.ties.energy();
    const model::NodalLoads loads_after = tied_.loads(after);
    const double pull = test::kTieStiffness * tied_.ties.largest_stretch();
    EXPECT_NEAR(tied_.ties.energy(), energy, 1e-12 * energy);
    for (std::size_t i = 0; i < tied_.model.nodes.size(); ++i) {
      EXPECT_LT((vector_at(loads_after.force, i) - rotation * vector_at(loads_before.force, i)).norm(), 1e-12 * pull);
      EXPECT_LT((vector_at(loads_after.moment, i) - rotation * vector_at(loads_before.moment, i)).norm(), 1e-12 * pull);
    }
  }
}

/// Nodes 5 to 8 are the second yarn.
model::State with_second_yarn(const model::Model& model, const Eigen::Quaterniond& rotation, const Vector3d& about,
                              const Vector3d& by) {
  model::State state = test::state_of(model);
  for (std::size_t i = 5; i < model.nodes.size(); ++i) {
    const Vector3d place = rotation * (model.nodes[i] - about) + about + by;
    state.position.set(i, {place.x(), place.y(), place.z()});
    test::set_rotation(state, i, rotation);
  }
  return state;
}

TEST_P(YarnTiesOn, GivenOneYarnThatIsMovedAway_ThenEveryTieIsStretchedByThatAndHoldsHalfKD2) {
  const Vector3d by(0.02, -0.03, 0.06);
  const model::NodalLoads loads =
      tied_.loads(with_second_yarn(tied_.model, Eigen::Quaterniond::Identity(), Vector3d::Zero(), by));
  EXPECT_NEAR(tied_.ties.largest_stretch(), 0.07, 1e-14);  // sqrt(0.02^2 + 0.03^2 + 0.06^2)
  EXPECT_NEAR(tied_.ties.energy(), 2 * 0.5 * test::kTieStiffness * 0.0049, 1e-13);
  Vector3d force = Vector3d::Zero();
  for (std::size_t i = 5; i < tied_.model.nodes.size(); ++i) force += vector_at(loads.force, i);
  EXPECT_LT((force + 2 * test::kTieStiffness * by).norm(), 1e-12);
}

TEST_P(YarnTiesOn, GivenOneYarnThatTurnsAboutATiedPoint_ThenThatTieLetsIt) {
  model::Model model = test::tied_yarns(GetParam());
  model.ties.resize(1);
  Tied one(model);
  one.line.update(test::state_of(model), {}, 0);
  // The tied point lies halfway between both centrelines.
  const Vector3 between = 0.5 * (one.line.point(model.ties[0].first) + one.line.point(model.ties[0].second));
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Quaterniond rotation = test::turn(test::random_vector(random_));
    (void)one.loads(with_second_yarn(model, rotation, {between.x, between.y, between.z}, Vector3d::Zero()));
    EXPECT_LT(one.ties.largest_stretch(), 1e-14);
  }
}

TEST_P(YarnTiesOn, GivenAFrame_ThenItHasTheForcesOnTheNodes) {
  const model::NodalLoads loads = tied_.loads(test::deformed(tied_.model, random_, 0.1, 0.3));
  model::Frame frame;
  frame.points = tied_.model.nodes;
  tied_.ties.set_results(tied_.line, frame);
  ASSERT_EQ(frame.tie_force.size(), tied_.model.nodes.size());
  for (std::size_t i = 0; i < frame.tie_force.size(); ++i) {
    EXPECT_LT((frame.tie_force[i] - vector_at(loads.force, i)).norm(), 1e-13);
  }
}

TEST_P(YarnTiesOn, GivenAModelWithoutTies_ThenNothingActsAndNothingIsStored) {
  model::Model model = test::tied_yarns(GetParam());
  model.ties.clear();
  Tied none(model);
  EXPECT_EQ(none.energy(test::deformed(model, random_, 0.3, 1.0)), 0);
  EXPECT_EQ(none.ties.largest_stretch(), 0);
}

}  // namespace
}  // namespace knitmech
