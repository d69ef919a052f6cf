#include "contact/neighbour_search.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>

#include "../../support/beam_case.h"
#include "base/segment_distance.h"
#include "contact/search_around.h"

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
    const Eigen::Vector3d next = nodes.back() + step(random) * Eigen::Vector3d(x, y, normal(random)).normalized();
    nodes.push_back(next);
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

TEST(NeighbourSearch, GivenSomeElementsThatAreDue_ThenBothSearchesFindExactlyThePairsOfThese) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 20; ++trial) {
    model::Model model = test::yarns_through({tangle(random, 60), tangle(random, 40), tangle(random, 1)},
                                             test::section(19, 6, 0.017, 0.012, 1e-11, 0.12));
    model.centreline = model::Centreline::chords;
    const ContactElements elements = make_contact_elements(model);
    const model::State state = test::state_of(model);
    Centreline line(model);
    line.update(state, {}, 0);
    std::vector<char> is_due(elements.n_nodes(), 0);
    std::vector<std::int32_t> due;
    for (std::size_t i = 0; i < elements.n_nodes(); ++i) {
      if (std::uniform_int_distribution<int>(0, 4)(random) > 0) continue;
      is_due[i] = 1;
      due.push_back(static_cast<std::int32_t>(i));
    }
    std::vector<ElementPair> expected = brute_force(elements, state.position, 0.05);
    std::erase_if(expected, [&](ElementPair pair) {
      return is_due[static_cast<std::size_t>(pair.first)] == 0 && is_due[static_cast<std::size_t>(pair.second)] == 0;
    });
    ASSERT_GT(expected.size(), 0U);
    const std::vector<double> no_bulge(elements.n_nodes(), 0.0);
    EXPECT_EQ(find_neighbours(elements, state.position, no_bulge, 0.05, is_due), expected);
    EXPECT_EQ(search_around(due, elements, line, 0.05), expected);
  }
}

/// The least distance of points of two curves, 20 steps on each [mm].
double sampled_distance(const Curve& first, const Curve& second) {
  double least = 1e9;
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      least = std::min(least, length(combine(first, hermite(i / 20.0)) - combine(second, hermite(j / 20.0))));
    }
  }
  return least;
}

/// The pairs of pieces that come nearer than the given distance [mm] of their centrelines, in order.
std::vector<ElementPair> near_pairs(const ContactElements& pieces, const Centreline& line, double distance) {
  std::vector<ElementPair> pairs;
  for (std::size_t a = 0; a < pieces.n_nodes(); ++a) {
    for (std::size_t b = a + 1; b < pieces.n_nodes(); ++b) {
      if (!pieces.exists[a] || !pieces.exists[b] || too_near_along_yarn(pieces, a, b)) continue;
      const ElementPair pair{static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)};
      const Curve first = line.piece_curve(pieces, pair.first);
      if (sampled_distance(first, line.piece_curve(pieces, pair.second)) < distance) pairs.push_back(pair);
    }
  }
  return pairs;
}

TEST(NeighbourSearch, GivenCurvedElementsThatAreDue_ThenNoNearPairOfPiecesIsMissed) {
  std::mt19937 random(31);
  std::size_t n_near = 0;
  for (int trial = 0; trial < 20; ++trial) {
    model::Model model =
        test::yarns_through({tangle(random, 30), tangle(random, 30)}, test::section(19, 6, 0.017, 0.012, 1e-11, 0.12));
    model.centreline = model::Centreline::smooth;
    const ContactElements pieces = make_contact_elements(model);
    Centreline line(model);
    line.update(test::state_of(model), {}, 0);
    std::vector<std::int32_t> all(model.nodes.size());
    std::iota(all.begin(), all.end(), 0);
    const std::vector<ElementPair> found = search_around(all, pieces, line, 0.05);
    const std::vector<ElementPair> near = near_pairs(pieces, line, 0.12 + 0.05);
    n_near += near.size();
    for (const ElementPair pair : near) {
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), pair))
          << trial << ": " << pair.first << ", " << pair.second;
    }
  }
  EXPECT_GT(n_near, 100U);
}

/// Straight yarns of elements of 0.4 mm, 0.4 mm apart, in two layers across each other, turned in space.
std::vector<std::vector<Eigen::Vector3d>> weave(int n_yarns, double turn) {
  const Eigen::AngleAxisd rotation(turn, Eigen::Vector3d(2, 3, 1).normalized());
  std::vector<std::vector<Eigen::Vector3d>> yarns;
  for (int y = 0; y < n_yarns; ++y) {
    const double aside = 0.4 * (y + 0.5);
    const double end = 0.4 * n_yarns;
    yarns.push_back(test::straight({0, aside, 0}, {end, aside, 0}, n_yarns));
    yarns.push_back(test::straight({aside, 0, 0.15}, {aside, end, 0.15}, n_yarns));
  }
  for (std::vector<Eigen::Vector3d>& yarn : yarns) {
    for (Eigen::Vector3d& point : yarn) point = rotation * point;
  }
  return yarns;
}

double comparisons_per_element(const std::vector<std::vector<Eigen::Vector3d>>& yarns) {
  model::Model model = test::yarns_through(yarns, test::section(19, 6, 0.017, 0.012, 1e-11, 0.12));
  model.centreline = model::Centreline::chords;
  SearchCost cost;
  const auto pairs = find_neighbours(make_contact_elements(model), test::state_of(model).position,
                                     std::vector<double>(model.nodes.size(), 0.0), 0.05, {}, &cost);
  EXPECT_GE(4 * pairs.size(), static_cast<std::size_t>(model.n_elements()));  // it was no search of nothing
  return static_cast<double>(cost.compared) / model.n_elements();
}

TEST(NeighbourSearch, GivenFabricsUpToAHundredTimesLarger_ThenAnElementIsComparedAsOften) {
  const double small = comparisons_per_element(weave(12, 0));
  EXPECT_LT(comparisons_per_element(weave(40, 0)), 1.25 * small);
  EXPECT_LT(comparisons_per_element(weave(120, 0)), 1.25 * small);
}

TEST(NeighbourSearch, GivenAFabricThatLiesAslantInSpace_ThenAnElementIsComparedAsOften) {
  // The box around it holds hundreds of times as many cells as the fabric; those around an element change with the
  // turn.
  EXPECT_LT(comparisons_per_element(weave(120, 0.7)), 1.5 * comparisons_per_element(weave(120, 0)));
}

TEST(NeighbourSearch, GivenAYarnOfAFabricFlungFarAway_ThenAnElementIsComparedAsOften) {
  std::vector<std::vector<Eigen::Vector3d>> yarns = weave(40, 0);
  const double before = comparisons_per_element(yarns);
  for (Eigen::Vector3d& point : yarns.front()) point += Eigen::Vector3d(1e6, -1e6, 1e6);
  EXPECT_LE(comparisons_per_element(yarns), before);
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
