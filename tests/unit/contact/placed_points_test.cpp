#include "contact/placed_points.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "crossing_scenes.h"

namespace knitmech::contact {
namespace {

/// Two yarns of bent elements with bows, turned and moving.
struct Moving {
  Scene scene;
  explicit Moving(std::mt19937& random) : scene(make(random)) {}

  static Scene make(std::mt19937& random) {
    const model::Model model = bent_yarns(random);
    model::State state = turned_state(model, random);
    for (std::size_t i = 0; i < 8; ++i) {
      state.velocity.set(i, noise(random, 3));
      state.angular_velocity.set(i, noise(random, 10));
    }
    return {model, state};
  }
};

TEST(PlacedPoints, GivenMovingYarns_ThenPointsHavePositionsAndVelocitiesOfTheirPlaces) {
  std::mt19937 random(7);
  const Moving yarns(random);
  const Scene& scene = yarns.scene;
  PlacedPoints points;
  EXPECT_EQ(points.add(1, {0.0, 0.3, 1.0}), 0U);
  EXPECT_EQ(points.add(5, {0.7}), 3U);
  points.begin_step();
  points.bring(0, scene.line, scene.state);
  points.bring(1, scene.line, scene.state);
  ASSERT_EQ(points.size(), 4U);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const YarnPlace place = points.place(p);
    EXPECT_LT(length(points.position(p) - scene.line.point(place)), 1e-14);
    EXPECT_LT(length(points.velocity(p) - scene.line.velocity(scene.state, place)), 1e-12);
  }
}

TEST(PlacedPoints, GivenForcesOnThem_ThenTheNodesGetWhatForcesAtThePlacesGive) {
  std::mt19937 random(11);
  const Moving yarns(random);
  const Scene& scene = yarns.scene;
  PlacedPoints points;
  points.add(1, {0.1, 0.5, 0.9});
  points.add(5, {0.2, 0.4});
  points.begin_step();
  points.bring(0, scene.line, scene.state);
  points.bring(1, scene.line, scene.state);
  model::NodalLoads expected(8);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vector3 force = noise(random, 1);
    points.add_force(p, force);
    scene.line.spread(points.place(p), force, expected);
  }
  model::NodalLoads loads(8);
  points.give_forces(scene.line, loads);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_LT(length(loads.force.at(i) - expected.force.at(i)), 1e-13);
    EXPECT_LT(length(loads.moment.at(i) - expected.moment.at(i)), 1e-13);
  }
}

}  // namespace
}  // namespace knitmech::contact
