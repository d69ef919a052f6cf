#include "contact/crossing_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "contact/friction.h"
#include "crossing_scenes.h"

namespace knitmech::contact {
namespace {

constexpr double kDensity = 2e4;      // N/mm^3
constexpr double kFriction = 0.3;     // -
constexpr double kStick = 16.0;       // N/mm
constexpr double kStep = 1e-6;        // s
constexpr double kExactness = 1e-12;  // -, of all results

/// What a contact does, by the plain functions.
struct Plain {
  Followed here;
  PairLoad pair;
  SlipMemory stick;
  double loss = 0;  ///< [mJ]
  model::NodalLoads loads{8};
  double limit = 0;     ///< of friction [N]
  Vector3 motion = {};  ///< [mm]
};

Plain plain(const Scene& scene) {
  Plain result;
  result.here = follow(scene);
  const Followed& here = result.here;
  const double distance = length(here.at.between);
  const PairSize size{kRadii, kDensity, scene.elements.length[1], scene.elements.length[5]};
  result.pair = crossing_load(here.at, here.hessian, distance, size);
  result.stick = scene.stick;
  result.limit = kFriction * result.pair.load;
  result.motion =
      kStep * (scene.line.velocity(scene.state, here.second) - scene.line.velocity(scene.state, here.first));
  const Vector3 normal = (1 / distance) * here.at.between;
  const FrictionStep friction = friction_step(result.stick, normal, result.motion, result.limit, kStick);
  result.loss = friction.loss;
  CurveLoad on_first = result.pair.on_first;
  CurveLoad on_second = result.pair.on_second;
  on_first.force = on_first.force - friction.force;
  on_second.force = on_second.force + friction.force;
  scene.line.spread(here.first, on_first, result.loads);
  scene.line.spread(here.second, on_second, result.loads);
  return result;
}

void put_side(const Scene& scene, YarnPlace place, LaneSides& side, std::size_t lane) {
  const auto i = static_cast<std::size_t>(place.element);
  set_element(side, lane, scene.line.element(i));
  side.start_velocity.set(lane, scene.state.velocity.at(i));
  side.end_velocity.set(lane, scene.state.velocity.at(i + 1));
  side.start_turning.set(lane, scene.state.angular_velocity.at(i));
  side.end_turning.set(lane, scene.state.angular_velocity.at(i + 1));
  side.share[lane] = place.share;
  const double arc = arc_of(scene.elements, place);
  side.to_end[lane] = std::min(arc, scene.elements.before[i] + scene.elements.after[i] - arc);
}

void put(const Scene& scene, ContactBatch& batch, std::size_t lane) {
  put_side(scene, scene.first, batch.first, lane);
  put_side(scene, scene.second, batch.second, lane);
  batch.radii[lane] = kRadii;
  batch.density[lane] = kDensity;
  batch.friction[lane] = kFriction;
  batch.stick_stiffness[lane] = kStick;
  batch.elastic_slip.set(lane, scene.stick.elastic_slip);
  batch.normal.set(lane, scene.stick.normal);
  batch.n = std::max(batch.n, lane + 1);
}

void expect_near(Vector3 a, Vector3 b, double size) {
  EXPECT_LE(length(a - b), kExactness * size);
}

void expect_same_loads(const ContactBatch& batch, std::size_t lane, const Plain& expected) {
  double force = expected.pair.load;
  double moment = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    force = std::max(force, length(expected.loads.force.at(i)));
    moment = std::max(moment, length(expected.loads.moment.at(i)));
  }
  expect_near(batch.first.start_force.at(lane), expected.loads.force.at(1), force);
  expect_near(batch.first.end_force.at(lane), expected.loads.force.at(2), force);
  expect_near(batch.second.start_force.at(lane), expected.loads.force.at(5), force);
  expect_near(batch.second.end_force.at(lane), expected.loads.force.at(6), force);
  expect_near(batch.first.start_moment.at(lane), expected.loads.moment.at(1), moment);
  expect_near(batch.first.end_moment.at(lane), expected.loads.moment.at(2), moment);
  expect_near(batch.second.start_moment.at(lane), expected.loads.moment.at(5), moment);
  expect_near(batch.second.end_moment.at(lane), expected.loads.moment.at(6), moment);
}

void expect_same(const ContactBatch& batch, std::size_t lane, const Scene& scene, const Plain& expected) {
  ASSERT_EQ(batch.regular[lane], 1.0);
  expect_same_loads(batch, lane, expected);
  const double distance = length(expected.here.at.between);
  const double slip = expected.limit / kStick + length(expected.motion) + length(scene.stick.elastic_slip);
  EXPECT_NEAR(batch.first.share[lane], expected.here.first.share, kExactness);
  EXPECT_NEAR(batch.second.share[lane], expected.here.second.share, kExactness);
  EXPECT_NEAR(batch.penetration[lane], kRadii - distance, kExactness * kRadii);
  EXPECT_NEAR(batch.load[lane], expected.pair.load, kExactness * expected.pair.load);
  EXPECT_NEAR(batch.tangent[lane], expected.pair.tangent, kExactness * expected.pair.tangent);
  EXPECT_NEAR(batch.energy[lane], expected.pair.energy, kExactness * expected.pair.energy);
  EXPECT_NEAR(batch.loss[lane], expected.loss, kExactness * kStick * slip * slip);
  EXPECT_NEAR(batch.slid[lane], expected.stick.slid, kExactness * slip);
  EXPECT_EQ(batch.slipped[lane] != 0, expected.stick.slips);
  EXPECT_EQ(batch.turned_round[lane], 0.0);
  expect_near(batch.elastic_slip.at(lane), expected.stick.elastic_slip, slip);
  expect_near(batch.normal.at(lane), expected.stick.normal, 1);
}

TEST(CrossingBatch, GivenThousandsOfRandomContacts_ThenEveryLaneIsWhatThePlainFunctionsSay) {
  std::mt19937 random(19);
  int slips = 0;
  constexpr int kBatches = 500;
  for (int trial = 0; trial < kBatches; ++trial) {
    ContactBatch batch{};
    std::vector<Scene> scenes;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      scenes.push_back(random_scene(random));
      put(scenes.back(), batch, lane);
    }
    evaluate_crossings(batch, kStep);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Plain expected = plain(scenes[lane]);
      slips += expected.stick.slips ? 1 : 0;
      expect_same(batch, lane, scenes[lane], expected);
      ASSERT_FALSE(HasFailure()) << "batch " << trial << ", lane " << lane;
    }
  }
  // Sticks and slips are both among them.
  EXPECT_GT(slips, kBatches);
  EXPECT_LT(slips, (static_cast<int>(kLanes) - 1) * kBatches);
}

constexpr double kUsual = 0.5 * kSmallOverlap * kRadii;  // mm, penetration

/// Whether a contact in the midst of usual ones says that it is regular; the others must not notice it.
bool is_regular(const Scene& scene, const std::function<void(ContactBatch&, std::size_t)>& change = {}) {
  const Scene usual = straight_scene(kUsual);
  constexpr std::size_t kLane = 3;
  ContactBatch batch{};
  for (std::size_t lane = 0; lane < kLanes; ++lane) put(lane == kLane ? scene : usual, batch, lane);
  if (change) change(batch, kLane);
  evaluate_crossings(batch, kStep);
  const Plain expected = plain(usual);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (lane != kLane) expect_same(batch, lane, usual, expected);
  }
  return batch.regular[kLane] != 0;
}

TEST(CrossingBatch, GivenAnOverlapThatIsNotSmall_ThenItsLaneIsNotRegular) {
  EXPECT_TRUE(is_regular(straight_scene(0.999 * kSmallOverlap * kRadii)));
  EXPECT_FALSE(is_regular(straight_scene(1.001 * kSmallOverlap * kRadii)));
  EXPECT_FALSE(is_regular(straight_scene(0.5 * kRadii)));
}

TEST(CrossingBatch, GivenYarnsThatDoNotTouch_ThenTheirLaneIsNotRegular) {
  EXPECT_TRUE(is_regular(straight_scene(1e-6)));
  EXPECT_FALSE(is_regular(straight_scene(-1e-6)));
  EXPECT_FALSE(is_regular(straight_scene(-0.1)));
}

TEST(CrossingBatch, GivenAPlaceThatLeavesItsElement_ThenItsLaneIsNotRegular) {
  const auto leaves = [](double from) {
    return [from](ContactBatch& batch, std::size_t lane) { batch.second.share[lane] = from; };
  };
  EXPECT_TRUE(is_regular(straight_scene(kUsual, 0.5, 0.99999), leaves(0.99995)));
  EXPECT_FALSE(is_regular(straight_scene(kUsual, 0.5, 1.00001), leaves(0.99995)));
  EXPECT_TRUE(is_regular(straight_scene(kUsual, 0.5, 0.00001), leaves(0.00005)));
  EXPECT_FALSE(is_regular(straight_scene(kUsual, 0.5, -0.00001), leaves(0.00005)));
}

TEST(CrossingBatch, GivenAPlaceThatMovesFar_ThenItsLaneIsNotRegular) {
  const auto starts_off_by = [](double shares) {
    return [shares](ContactBatch& batch, std::size_t lane) { batch.second.share[lane] += shares; };
  };
  for (const double sign : {-1, 1}) {
    EXPECT_TRUE(is_regular(straight_scene(kUsual), starts_off_by(sign * 0.99 * kFineStep)));
    EXPECT_FALSE(is_regular(straight_scene(kUsual), starts_off_by(sign * 1.01 * kFineStep)));
  }
}

TEST(CrossingBatch, GivenAYarnThatEndsWithinTheOverlap_ThenItsLaneIsNotRegular) {
  // The gap of yarns at a right angle grows by y^2 / (2 distance): the overlap ends sqrt(2 d distance) off its middle.
  const double half = std::sqrt(2 * kUsual * (kRadii - kUsual));
  const auto ends_after = [](double to_end) {
    return [to_end](ContactBatch& batch, std::size_t lane) { batch.second.to_end[lane] = to_end; };
  };
  EXPECT_TRUE(is_regular(straight_scene(kUsual), ends_after(1.001 * half)));
  EXPECT_FALSE(is_regular(straight_scene(kUsual), ends_after(0.999 * half)));
  EXPECT_FALSE(is_regular(straight_scene(kUsual), ends_after(0)));
}

TEST(CrossingBatch, GivenAFirstYarnThatLeavesItsElementMovesFarOrEnds_ThenTheLaneIsNotRegularEither) {
  const auto starts = [](double share) {
    return [share](ContactBatch& batch, std::size_t lane) { batch.first.share[lane] = share; };
  };
  EXPECT_TRUE(is_regular(straight_scene(kUsual, 0.99999), starts(0.99995)));
  EXPECT_FALSE(is_regular(straight_scene(kUsual, 1.00001), starts(0.99995)));
  EXPECT_TRUE(is_regular(straight_scene(kUsual), starts(0.5 + 0.99 * kFineStep)));
  EXPECT_FALSE(is_regular(straight_scene(kUsual), starts(0.5 + 1.01 * kFineStep)));
  const double half = std::sqrt(2 * kUsual * (kRadii - kUsual));
  const auto ends_after = [](double to_end) {
    return [to_end](ContactBatch& batch, std::size_t lane) { batch.first.to_end[lane] = to_end; };
  };
  EXPECT_TRUE(is_regular(straight_scene(kUsual), ends_after(1.001 * half)));
  EXPECT_FALSE(is_regular(straight_scene(kUsual), ends_after(0.999 * half)));
}

TEST(CrossingBatch, GivenANormalThatHasTurnedRound_ThenItsLaneSaysSo) {
  for (const double old : {-1.0, 0.0, 1.0}) {
    ContactBatch batch{};
    Scene scene = straight_scene(kUsual);
    scene.stick.normal = {0, 0, old};
    put(scene, batch, 0);
    evaluate_crossings(batch, kStep);
    EXPECT_EQ(batch.regular[0], 1.0);
    EXPECT_EQ(batch.turned_round[0], old < 0 ? 1.0 : 0.0);
    EXPECT_NEAR(batch.normal.z[0], 1, 1e-15);
  }
}

}  // namespace
}  // namespace knitmech::contact
