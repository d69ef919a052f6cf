#include "contact/neighbour_search.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "../../support/beam_case.h"
#include "base/segment_distance.h"

namespace knitmech::contact {
namespace {

/// A random walk with steps of 0.1 to 0.6 mm.
std::vector<Eigen::Vector3d> tangle(std::mt19937& random, int n_elements) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> step(0.1, 0.6);
  std::vector<Eigen::Vector3d> nodes{{normal(random), normal(random), normal(random)}};
  for (int i = 0; i < n_elements; ++i) {
    const double x = normal(random);
    const double y = normal(random);
    nodes.push_back(nodes.back() + step(random) * Eigen::Vector3d(x, y, normal(random)).normalized());
  }
  return nodes;
}

std::vector<ElementPair> brute_force(const ContactElements& elements, const model::VectorArray& x, double skin) {
  std::vector<ElementPair> pairs;
  for (std::size_t a = 0; a < elements.n_nodes(); ++a) {
    for (std::size_t b = a + 1; b < elements.n_nodes(); ++b) {
      if (!elements.exists[a] || !elements.exists[b] || too_near_along_yarn(elements, a, b)) continue;
      const Vector3 u = x.at(a + 1) - x.at(a);
      const Vector3 v = x.at(b + 1) - x.at(b);
      const ClosestPoints at = closest_points(x.at(a), u, x.at(b), v);
      const double distance = length(x.at(b) + at.t * v - x.at(a) - at.s * u);
      if (distance < elements.radius[a] + elements.radius[b] + skin) {
        pairs.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
      }
    }
  }
  return pairs;
}

TEST(NeighbourSearch, GivenRandomTangles_ThenItFindsExactlyThePairsOfAPlainSearch) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    model::Model model = test::yarns_through({tangle(random, 60), tangle(random, 40), tangle(random, 1)},
                                             test::section(19, 6, 0.017, 0.012, 1e-11, 0.12));
    model.centreline = model::Centreline::chords;
    const ContactElements elements = make_contact_elements(model);
    const model::State state = test::state_of(model);
    const auto found = find_neighbours(elements, state.position, std::vector<double>(elements.n_nodes(), 0.0), 0.05);
    const auto expected = brute_force(elements, state.position, 0.05);
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_GT(found.size(), 0U);
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].first, expected[i].first);
      EXPECT_EQ(found[i].second, expected[i].second);
    }
  }
}

TEST(NeighbourSearch, GivenOneYarnFlungFarAway_ThenTheGridDoesNotGrowWithTheDistance) {
  model::Model model = test::yarns_through(
      {test::straight({0, 0, 0}, {10, 0, 0}, 20), test::straight({1e6, 1e6, 1e6}, {1e6 + 1, 1e6, 1e6}, 2)},
      test::section(19, 6, 0.017, 0.012, 1e-11, 0.12));
  model.centreline = model::Centreline::chords;
  EXPECT_TRUE(find_neighbours(make_contact_elements(model), test::state_of(model).position,
                              std::vector<double>(model.nodes.size(), 0.0), 0.05)
                  .empty());
}

TEST(NeighbourSearch, GivenElementsShorterThanTheYarnIsThick_ThenOnlyPiecesThatCanTouchAreNeighbours) {
  const double diameter = 0.12;
  const double element = 0.02;
  model::Model model = test::yarns_through({test::straight({0, 0, 0}, {2, 0, 0}, 100)},
                                           test::section(19, 6, 0.017, 0.012, 1e-11, diameter));
  model.centreline = model::Centreline::chords;
  const ContactElements elements = make_contact_elements(model);
  // A half turn with the centreline as tight as the yarn's own radius: arc pi D / 2 between the touching points.
  const double least_arc = std::numbers::pi * diameter / 2;
  for (std::size_t second = 2; second < 30; ++second) {
    const double between = element * static_cast<double>(second - 1);
    EXPECT_EQ(too_near_along_yarn(elements, 0, second), between < least_arc) << "element " << second;
  }
}

}  // namespace
}  // namespace knitmech::contact
