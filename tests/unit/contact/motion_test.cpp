#include "contact/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "../../support/beam_case.h"
#include "contact/centreline.h"
#include "contact/pair_watch.h"

namespace knitmech::contact {
namespace {

/// Moves nodes that do not turn.
void add(Motion& motion, const std::vector<double>& moved, double besides = 0) {
  motion.add(moved, std::vector<double>(moved.size(), 0.0), besides);
}

/// Nodes at random heights, with the velocities along y that a function of the height says.
template <typename Velocity>
model::State moving_state(std::mt19937& random, const Velocity& velocity) {
  std::uniform_real_distribution<double> height(-20, 50);
  model::State state(100);
  for (std::size_t i = 0; i < 100; ++i) {
    state.position.y[i] = height(random);
    state.velocity.y[i] = velocity(state.position.y[i]);
  }
  return state;
}

TEST(CommonMotion, GivenVelocitiesLinearInTheHeight_ThenTheFitIsExact) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-5, 5);
  for (int trial = 0; trial < 100; ++trial) {
    const double a = number(random);
    const double b = number(random);
    const CommonMotion fit = fit_common_motion(moving_state(random, [&](double y) { return a + b * y; }));
    EXPECT_NEAR(fit.start, a, 1e-12);
    EXPECT_NEAR(fit.rate, b, 1e-13);
  }
}

TEST(CommonMotion, GivenAnyVelocities_ThenWhatIsLeftHasNoMeanAndNoSlope) {
  // The condition of least squares: the residuals are orthogonal to 1 and to y.
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const model::State state = moving_state(random, [&](double y) { return 2 - 0.3 * y + normal(random); });
  const CommonMotion fit = fit_common_motion(state);
  double sum = 0;
  double moment = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    const double y = state.position.y[i];
    const double left = state.velocity.y[i] - fit.start - fit.rate * y;
    sum += left;
    moment += left * y;
  }
  EXPECT_NEAR(sum, 0, 1e-11);
  EXPECT_NEAR(moment, 0, 1e-9);
}

TEST(CommonMotion, GivenNodesAtOneHeight_ThenItIsTheirMeanVelocity) {
  model::State state(4);
  state.velocity.y = {1, 2, 3, 6};
  const CommonMotion fit = fit_common_motion(state);
  EXPECT_DOUBLE_EQ(fit.start, 3);
  EXPECT_EQ(fit.rate, 0.0);
}

TEST(Motion, GivenSteps_ThenAnElementHasMovedAsItsFasterNodeAndWhatComesBesides) {
  Motion motion(4);
  add(motion, {1, 0, 0, 4}, 0.25);
  add(motion, {0, 2, 0, 0}, 0.5);
  EXPECT_EQ(motion.of(0), 1.25 + 2.5);
  EXPECT_EQ(motion.of(1), 0.25 + 2.5);
  EXPECT_EQ(motion.of(2), 4.25 + 0.5);
  EXPECT_EQ(motion.largest_since_check(), 4.75);
}

TEST(Motion, GivenANewFabric_ThenASearchIsDueAtOnce) {
  Motion motion(3);
  add(motion, {0, 0, 0});
  EXPECT_TRUE(motion.has_reached_a_bound());
  EXPECT_GT(motion.largest_since_search(), 1e100);
}

TEST(Motion, GivenASearchOfAnElement_ThenOnlyItsMotionSinceThenBeginsAnew) {
  Motion motion(3);
  motion.searched(0);
  motion.searched(1);
  add(motion, {1, 2, 1});
  motion.searched(1);
  add(motion, {1, 1, 1});
  EXPECT_EQ(motion.since_search(0), 3);
  EXPECT_EQ(motion.since_search(1), 1);
  motion.checked();
  EXPECT_EQ(motion.largest_since_check(), 0);
  EXPECT_EQ(motion.of(0), 3);
}

TEST(Motion, GivenABoundForTwoElements_ThenOneOfThemReachesItBeforeBothTogetherHaveMovedThatFar) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 100; ++trial) {
    Motion motion(4);
    for (const std::size_t i : {0U, 1U, 2U}) {
      motion.searched(i);
      motion.unbind(i);
    }
    motion.bound(0, 2, 1.0);
    while (!motion.has_reached_a_bound()) add(motion, {0.01 * uniform(random), 0, 0, 0.02 * uniform(random)});
    EXPECT_LT(motion.of(0) + motion.of(2), 1.0 + 0.03);
    EXPECT_GE(std::max(motion.of(0), motion.of(2)), 0.5);
  }
}

TEST(Motion, GivenBoundsSinceSearchAndCheck_ThenTheNearerOneCounts) {
  Motion motion(2);
  motion.set_limits(3.0, 2.0);
  motion.searched(0);
  motion.unbind(0);
  add(motion, {1.5, 0});
  EXPECT_FALSE(motion.has_reached_a_bound());
  motion.checked();
  motion.unbind(0);
  add(motion, {1.4, 0});
  EXPECT_FALSE(motion.has_reached_a_bound());
  add(motion, {0.2, 0});
  EXPECT_TRUE(motion.has_reached_a_bound());  // 3.1 since the search, 1.6 since the check
}

/// Two bent yarns of two elements each, nodes 0 to 2 and 3 to 5.
model::Model bent_yarns(std::mt19937& random) {
  std::normal_distribution<double> normal(0, 0.1);
  std::vector<std::vector<Eigen::Vector3d>> yarns(2);
  for (std::size_t y = 0; y < 2; ++y) {
    for (int i = 0; i < 3; ++i) {
      const double a = normal(random);
      yarns[y].emplace_back(0.4 * i, a + 0.3 * static_cast<double>(y), normal(random));
    }
  }
  model::Model model = test::yarns_through(yarns, test::section(1, 1, 1, 1, 1, 0.1));
  for (std::size_t i = 0; i < 6; ++i) {
    const double a = normal(random);
    model.middles.emplace_back(0.5 * (model.nodes[i] + model.nodes[std::min<std::size_t>(i + 1, 5)]) +
                               0.3 * Eigen::Vector3d(normal(random), a, normal(random)));
  }
  return model;
}

constexpr std::array<std::size_t, 4> kElements = {0, 1, 3, 4};
constexpr int kPlaces = 8;  // on an element

std::vector<Vector3> places_on(const Centreline& line) {
  std::vector<Vector3> places;
  for (const std::size_t element : kElements) {
    for (int k = 0; k <= kPlaces; ++k) {
      places.push_back(combine(line.curve(element), hermite(static_cast<double>(k) / kPlaces)));
    }
  }
  return places;
}

std::size_t element_of(std::size_t place) {
  return kElements[place / (kPlaces + 1)];
}

/// Moves and turns every node a little at random, and all of them by the common motion.
void move_randomly(std::mt19937& random, model::State& state, CommonMotion common, double step) {
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < state.position.size(); ++i) {
    const double a = normal(random);
    const double b = normal(random);
    state.position.add(i, 0.01 * Vector3{a, b, normal(random)});
    state.position.y[i] += step * (common.start + common.rate * state.position.y[i]);
    const double c = normal(random);
    const double d = normal(random);
    const Eigen::Quaterniond turn = test::turn(0.05 * Eigen::Vector3d(c, d, normal(random)));
    test::set_rotation(state, i, (turn * test::rotation_of(state, i)).normalized());
  }
}

/// Half of what a common stretch may bring any two places nearer: they are weighted means of nodes along y, apart from
/// tangents and bows, which the stretch does not move.
double half_of_common_approach(const model::State& state, double stretch) {
  const auto [low, high] = std::minmax_element(state.position.y.begin(), state.position.y.end());
  return 0.5 * std::abs(stretch) * (*high - *low);
}

TEST(Motion, GivenRandomMotionsAndTurns_ThenNoTwoPlacesComeNearerThanTheirElementsHaveMoved) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  constexpr double kStep = 0.01;  // s
  for (int trial = 0; trial < 300; ++trial) {
    const model::Model model = bent_yarns(random);
    model::State state = test::state_of(model);
    Centreline line(model);
    line.update(state, {}, 0);
    const std::vector<Vector3> before = places_on(line);
    const CommonMotion common{10 * normal(random), 2 * normal(random)};
    Motion motion(model.nodes.size());
    for (int step = 0; step < 4; ++step) {
      move_randomly(random, state, common, kStep);
      line.update(state, common, kStep);
      motion.add(line.moved(), line.turned(), half_of_common_approach(state, common.rate * kStep));
    }
    const std::vector<Vector3> after = places_on(line);
    for (std::size_t a = 0; a < before.size(); ++a) {
      for (std::size_t b = a + 1; b < before.size(); ++b) {
        const double approach = length(before[b] - before[a]) - length(after[b] - after[a]);
        ASSERT_LE(approach, motion.of(element_of(a)) + motion.of(element_of(b)) + 1e-12) << "trial " << trial;
      }
    }
  }
}

TEST(PairSight, GivenRandomMotionsAndTurns_ThenNoTwoPlacesMoveAgainstEachOtherByMoreThanItSays) {
  std::mt19937 random(13);
  for (int trial = 0; trial < 300; ++trial) {
    const model::Model model = bent_yarns(random);
    model::State state = test::state_of(model);
    Centreline line(model);
    line.update(state, {}, 0);
    Motion motion(model.nodes.size());
    const std::vector<Vector3> before = places_on(line);
    const auto sight = [&](std::size_t a, std::size_t b) { return sight_of(line.node_position(), motion, a, b); };
    std::vector<PairSight> then;
    for (const std::size_t a : kElements) {
      for (const std::size_t b : kElements) then.push_back(sight(a, b));
    }
    for (int step = 0; step < 4; ++step) {
      move_randomly(random, state, {}, 0);
      line.update(state, {}, 0);
      motion.add(line.moved(), line.turned(), 0);
    }
    const std::vector<Vector3> after = places_on(line);
    for (std::size_t a = 0; a < before.size(); ++a) {
      for (std::size_t b = 0; b < before.size(); ++b) {
        const PairSight& seen = then[a / (kPlaces + 1) * 4 + b / (kPlaces + 1)];
        const double moved = length((after[b] - after[a]) - (before[b] - before[a]));
        ASSERT_LE(moved, motion_between(seen, sight(element_of(a), element_of(b))) + 1e-12) << "trial " << trial;
      }
    }
  }
}

TEST(PairSight, GivenYarnsThatMoveTogether_ThenTheyHaveNotMovedAgainstEachOther) {
  const model::Model model = test::yarns_through(
      {test::straight({0, 0, 0}, {1, 0, 0}, 2), test::straight({0, 0, 1}, {1, 0, 1}, 2)}, test::section(1, 1, 1, 1, 1));
  model::State state = test::state_of(model);
  Centreline line(model);
  line.update(state, {}, 0);
  Motion motion(6);
  const PairSight then = sight_of(line.node_position(), motion, 0, 3);
  for (std::size_t i = 0; i < 6; ++i) state.position.add(i, {2, -7, 3});
  line.update(state, {}, 0.01);
  motion.add(line.moved(), line.turned(), 0);
  EXPECT_GT(motion.of(0), 7);
  EXPECT_NEAR(motion_between(then, sight_of(line.node_position(), motion, 0, 3)), 0, 1e-14);
  // Then one of them by its own way.
  for (std::size_t i = 3; i < 6; ++i) state.position.add(i, {0, 0, -0.25});
  line.update(state, {}, 0.01);
  motion.add(line.moved(), line.turned(), 0);
  EXPECT_NEAR(motion_between(then, sight_of(line.node_position(), motion, 0, 3)), 0.25, 1e-14);
}

TEST(Motion, GivenYarnsThatMoveStraightAtEachOther_ThenTheBoundIsTheirApproach) {
  const model::Model model = test::yarns_through(
      {test::straight({0, 0, 0}, {1, 0, 0}, 2), test::straight({0, 0, 1}, {1, 0, 1}, 2)}, test::section(1, 1, 1, 1, 1));
  model::State state = test::state_of(model);
  Centreline line(model);
  line.update(state, {}, 0);
  Motion motion(6);
  for (int step = 0; step < 10; ++step) {
    for (std::size_t i = 0; i < 6; ++i) state.position.z[i] += i < 3 ? 0.02 : -0.03;
    line.update(state, {}, 0.01);
    motion.add(line.moved(), line.turned(), 0);
  }
  EXPECT_NEAR(motion.of(0) + motion.of(3), 0.5, 1e-14);
}

TEST(Motion, GivenNodesThatTurnInPlace_ThenTheBoundHoldsWhereTheCurvesBulgeTowardsEachOther) {
  // Turned by an angle at both ends of an element, the middle of a straight curve rises by L sin(angle) / 4 (Hermite).
  const model::Model model = test::yarns_through(
      {test::straight({0, 0, 0}, {1, 0, 0}, 1), test::straight({0, 0, 1}, {1, 0, 1}, 1)}, test::section(1, 1, 1, 1, 1));
  model::State state = test::state_of(model);
  Centreline line(model);
  line.update(state, {}, 0);
  Motion motion(4);
  constexpr double kAngle = 0.1;
  for (std::size_t i = 0; i < 4; ++i) {
    const double up = i == 0 || i == 3 ? -1 : 1;  // about y, a negative turn lifts what lies ahead along x
    test::set_rotation(state, i, test::turn({0, up * kAngle, 0}));
  }
  line.update(state, {}, 0.01);
  motion.add(line.moved(), line.turned(), 0);
  const double between = combine(line.curve(2), hermite(0.5)).z - combine(line.curve(0), hermite(0.5)).z;
  EXPECT_NEAR(1 - between, 0.5 * std::sin(kAngle), 1e-14);
  EXPECT_GE(motion.of(0) + motion.of(2), 1 - between);
  EXPECT_LE(motion.of(0) + motion.of(2), 1.5 * (1 - between)) << "a bound of use: a third of L for a quarter";
}

TEST(Motion, GivenAFabricThatOnlyFollowsTheCommonMotion_ThenNothingHasMovedBesideIt) {
  const model::Model model =
      test::yarns_through({test::straight({0, -3, 0}, {0, 4, 0}, 7)}, test::section(1, 1, 1, 1, 1));
  model::State state = test::state_of(model);
  Centreline line(model);
  line.update(state, {}, 0);
  const CommonMotion common{1.5, 0.4};
  // y_new = y_old + step (start + rate y_new)
  for (double& y : state.position.y) y = (y + 0.01 * common.start) / (1 - 0.01 * common.rate);
  line.update(state, common, 0.01);
  for (const double moved : line.moved()) EXPECT_NEAR(moved, 0, 1e-14);
}

/// Two pieces to an element: pieces 0 and 1 on element 0, 2 and 3 on element 1 and so on.
ContactElements halves() {
  ContactElements pieces;
  pieces.pieces_per_element = 2;
  return pieces;
}

/// Lets a watch look, every pair for a given length. \return the pairs that were looked at
std::vector<std::pair<int, int>> looked_at(PairWatch& watch, Motion& motion, double until, double early = 0) {
  std::vector<std::pair<int, int>> pairs;
  watch.look_at_all(halves(), early, motion, [&](ElementPair pair) {
    pairs.emplace_back(pair.first, pair.second);
    return until;
  });
  return pairs;
}

using Pairs = std::vector<std::pair<int, int>>;

const std::vector<char> kAll(12, 1);

TEST(PairWatch, GivenANewList_ThenEveryPairIsLookedAtOnce) {
  PairWatch watch;
  watch.renew(kAll, {{0, 5}, {1, 4}, {2, 7}});
  Motion motion(5);
  EXPECT_EQ(looked_at(watch, motion, 0.5), (Pairs{{0, 5}, {1, 4}, {2, 7}}));
  EXPECT_EQ(looked_at(watch, motion, 0.5), Pairs{});
}

TEST(PairWatch, GivenAPairThatSleeps_ThenItWakesWhenBothYarnsTogetherHaveMovedAsFarAsItWasTold) {
  PairWatch watch;
  watch.renew(kAll, {{1, 4}});  // on elements 0 and 2
  Motion motion(5);
  add(motion, {0.125, 0, 0, 0.125, 0});
  ASSERT_EQ(looked_at(watch, motion, 0.5).size(), 1U);  // element 0 has moved by 1/8, element 2 by 1/8
  add(motion, {0.25, 0, 0, 0, 0});
  add(motion, {0, 0, 0, 0.1875, 0});
  EXPECT_EQ(looked_at(watch, motion, 0.5), Pairs{}) << "7/16 are less than 1/2";
  add(motion, {0.0625, 0, 0, 0, 0});
  EXPECT_EQ(looked_at(watch, motion, 0.5), (Pairs{{1, 4}}));
  EXPECT_EQ(looked_at(watch, motion, 0.5), Pairs{});
  add(motion, {0, 0, 0, 0.5, 0});
  EXPECT_EQ(looked_at(watch, motion, 0.5), (Pairs{{1, 4}})) << "the next sleep counts from the look";
}

TEST(PairWatch, GivenAYarnThatMoves_ThenPairsOfOtherYarnsSleepOn) {
  PairWatch watch;
  watch.renew(kAll, {{0, 5}, {4, 8}});  // elements 0 and 2, 2 and 4
  Motion motion(6);
  looked_at(watch, motion, 0.5);
  add(motion, {8, 0, 0, 0, 0, 0});
  EXPECT_EQ(looked_at(watch, motion, 0.5), (Pairs{{0, 5}}));
}

TEST(PairWatch, GivenAPairThatMayTouchAtAnyTime_ThenItIsLookedAtEveryTime) {
  PairWatch watch;
  watch.renew(kAll, {{0, 5}});
  Motion motion(5);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(looked_at(watch, motion, 0).size(), 1U);
}

TEST(PairWatch, GivenASearchOfSomeElements_ThenTheirPairsAreThoseFound_AndWhatWasKnownSleepsOn) {
  PairWatch watch;
  watch.renew(kAll, {{0, 5}, {1, 8}, {4, 8}});
  Motion motion(6);
  looked_at(watch, motion, 100);
  std::vector<char> is_due(12, 0);
  is_due[0] = is_due[1] = 1;
  watch.renew(is_due, {{0, 5}, {1, 9}});
  const Pairs expected{{0, 5}, {1, 9}, {4, 8}};
  Pairs known;
  for (const ElementPair pair : watch.pairs()) known.emplace_back(pair.first, pair.second);
  EXPECT_EQ(known, expected);
  EXPECT_EQ(looked_at(watch, motion, 100), (Pairs{{1, 9}})) << "only the new one is awake";
}

TEST(PairWatch, GivenPairsThatHaveLittleLeft_ThenTheyAreLookedAtEarlyWithOthers) {
  PairWatch watch;
  watch.renew(kAll, {{0, 5}, {4, 8}});
  Motion motion(6);
  looked_at(watch, motion, 0.5);
  add(motion, {0.375, 0, 0, 0, 0, 0});
  EXPECT_EQ(looked_at(watch, motion, 0.5, 0.0625), Pairs{});
  EXPECT_EQ(looked_at(watch, motion, 0.5, 0.25), (Pairs{{0, 5}}));
}

TEST(PairWatch, GivenPairsThatSleep_ThenTheirElementsAreBoundedByWhatIsLeft) {
  PairWatch watch;
  watch.renew(kAll, {{0, 5}});
  Motion motion(6);
  for (std::size_t i = 0; i < 6; ++i) motion.searched(i);
  looked_at(watch, motion, 0.5);
  add(motion, {0.125, 0, 0, 0.125, 0, 0});
  EXPECT_FALSE(motion.has_reached_a_bound());
  add(motion, {0.125, 0, 0, 0, 0, 0});
  EXPECT_TRUE(motion.has_reached_a_bound()) << "one of the two has moved by half of what both may";
}

}  // namespace
}  // namespace knitmech::contact
