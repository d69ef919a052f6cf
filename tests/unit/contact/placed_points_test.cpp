#include "contact/placed_points.h"

#include <gtest/gtest.h>

#include <array>
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

constexpr std::array<PlaceRow, 2> kRows = {PlaceRow{1, 0.05, 0.1, 9}, PlaceRow{5, 0.25, 0.375, 2}};

struct PointAt {
  std::size_t point;  ///< number among the placed ones
  YarnPlace place;
};

std::vector<PointAt> points_of_rows() {
  std::vector<PointAt> points;
  std::size_t first = 0;
  for (const PlaceRow& row : kRows) {
    for (std::size_t i = 0; i < row.n; ++i) {
      points.push_back({first + i, {row.element, row.first + static_cast<double>(i) * row.step}});
    }
    first += rounded_up(row.n);
  }
  return points;
}

TEST(PlacedPoints, GivenMovingYarns_ThenPointsHavePositionsAndVelocitiesOfTheirPlaces) {
  std::mt19937 random(7);
  const Moving yarns(random);
  const Scene& scene = yarns.scene;
  PlacedPoints points;
  EXPECT_EQ(points.add(kRows[0], scene.line, scene.state), 0U);
  EXPECT_EQ(points.add(kRows[1], scene.line, scene.state), 16U) << "the next multiple of the points at once";
  for (const auto& [p, place] : points_of_rows()) {
    EXPECT_LT(length(points.position(p) - scene.line.point(place)), 1e-14);
    EXPECT_LT(length(points.velocity(p) - scene.line.velocity(scene.state, place)), 1e-12);
  }
}

TEST(PlacedPoints, GivenAPlace_ThenDepthsAreThoseBySquares) {
  std::mt19937 random(9);
  const Moving yarns(random);
  PlacedPoints points;
  for (const PlaceRow& row : kRows) points.add(row, yarns.scene.line, yarns.scene.state);
  const Vector3 place = points.position(4) + Vector3{0.05, 0.02, -0.03};
  std::array<double, 3> depth{};
  points.depths_below(place, 0.2, 3, 3, depth.data());
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 between = points.position(3 + i) - place;
    EXPECT_NEAR(depth[i], 0.5 * (0.2 - dot(between, between) / 0.2), 1e-15);
  }
  points.depths_below(points.position(2), 0.2, 2, 1, depth.data());
  EXPECT_LT(depth[0], 0.1) << "below the depth at which the centrelines meet";
}

TEST(PlacedPoints, GivenForcesOnThem_ThenTheNodesGetWhatForcesAtThePlacesGive) {
  std::mt19937 random(11);
  const Moving yarns(random);
  const Scene& scene = yarns.scene;
  PlacedPoints points;
  for (const PlaceRow& row : kRows) points.add(row, scene.line, scene.state);
  const double by = 3;
  const Vector3 from = noise(random, 1);
  const Vector3 besides = noise(random, 1);
  std::vector<double> weight(points.size() + kPointsAtOnce, 0.0);
  model::NodalLoads expected(8);
  Vector3 weighted_positions{};
  for (const auto& [p, place] : points_of_rows()) {
    weight[p] = noise(random, 1).x;
    scene.line.spread(place, weight[p] * (by * (points.position(p) - from) + besides), expected);
    if (p < 9) weighted_positions = weighted_positions + weight[p] * points.position(p);
  }
  EXPECT_LT(length(points.sum(0, 9, weight.data()).position - weighted_positions), 1e-14);
  points.add_forces(0, 9, weight.data(), by, from, besides);
  points.add_forces(16, 2, &weight[16], by, from, besides);
  const Vector3 alone = noise(random, 1);
  points.add_force(17, alone);
  scene.line.spread(points_of_rows().back().place, alone, expected);
  model::NodalLoads loads(8);
  for (std::size_t r = 0; r < 2; ++r) {
    const auto element = static_cast<std::size_t>(kRows[r].element);
    const EndLoads ends = points.to_nodes(scene.line.element(element), 16 * r, kRows[r].n);
    loads.force.add(element, ends.start_force);
    loads.force.add(element + 1, ends.end_force);
    loads.moment.add(element, ends.start_moment);
    loads.moment.add(element + 1, ends.end_moment);
  }
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_LT(length(loads.force.at(i) - expected.force.at(i)), 1e-13);
    EXPECT_LT(length(loads.moment.at(i) - expected.moment.at(i)), 1e-13);
  }
}

}  // namespace
}  // namespace knitmech::contact
