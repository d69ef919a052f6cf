#include "contact/frequency_bound.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "../../support/centrelines.h"
#include "tied_yarns.h"

namespace knitmech {
namespace {

struct Inertia {
  std::vector<double> mass, rotary;  // [t], [t mm^2]
};

Inertia random_inertia(std::size_t n_nodes, std::mt19937& random) {
  std::uniform_real_distribution<double> exponent(-1, 1);
  Inertia inertia;
  for (std::size_t i = 0; i < n_nodes; ++i) {
    inertia.mass.push_back(1e-11 * std::pow(10, exponent(random)));
    inertia.rotary.push_back(1e-12 * std::pow(10, exponent(random)));
  }
  return inertia;
}

/// Highest squared frequency of the ties alone about a state: the eigenvalues of their stiffness, the loads
/// differentiated numerically, over the inertia.
double highest_eigenvalue(test::Tied& tied, const model::State& state, const Inertia& inertia) {
  const auto n = static_cast<Eigen::Index>(tied.model.nodes.size());
  const double h = 1e-6;
  const auto loads_at = [&](const model::State& at) {
    const model::NodalLoads loads = tied.loads(at);
    Eigen::VectorXd all(6 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto node = static_cast<std::size_t>(i);
      all.segment<6>(6 * i) << test::vector_at(loads.force, node), test::vector_at(loads.moment, node);
    }
    return all;
  };
  Eigen::MatrixXd stiffness(6 * n, 6 * n);
  Eigen::VectorXd scale(6 * n);
  for (Eigen::Index column = 0; column < 6 * n; ++column) {
    const auto node = static_cast<std::size_t>(column / 6);
    const int axis = static_cast<int>(column % 6);
    stiffness.col(column) =
        (loads_at(test::nudged(state, node, axis, -h)) - loads_at(test::nudged(state, node, axis, h))) / (2 * h);
    scale[column] = 1 / std::sqrt(axis < 3 ? inertia.mass[node] : inertia.rotary[node]);
  }
  const Eigen::MatrixXd dynamic = scale.asDiagonal() * (0.5 * (stiffness + stiffness.transpose())) * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dynamic, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

class FrequencyBoundOn : public testing::TestWithParam<model::Centreline> {};
KNITMECH_WITH_EVERY_CENTRELINE(FrequencyBoundOn);

TEST_P(FrequencyBoundOn, GivenTiesBetweenAnyNodes_ThenNoFrequencyIsHigherAndTheHighestIsNotFarBelow) {
  // Both ties pull on the same elements. Gershgorin counts all row entries as if they pulled one way, along one line.
  test::Tied tied(test::tied_yarns(GetParam()));
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Inertia inertia = random_inertia(tied.model.nodes.size(), random);
    const model::State state = test::state_of(tied.model);
    const double highest = highest_eigenvalue(tied, state, inertia);
    const double bound = tied.ties.highest_frequency_squared(tied.line, inertia.mass, inertia.rotary);
    EXPECT_LE(highest, bound * (1 + 1e-6)) << "trial " << trial;
    EXPECT_GE(highest, bound / 5) << "trial " << trial;
  }
}

TEST(FrequencyBound, GivenOneSpringOnTheChordsBetweenEqualNodes_ThenItIsExact) {
  // Amid both elements, half a node's weight each: four equal entries of K / (4 m) in every row, so w^2 = 4 K / (4 m).
  const std::vector<double> mass(4, 2e-11), rotary(4, 1e-12);
  contact::FrequencyBound bound(mass, rotary);
  const contact::Hold amid{0.5, 0.5, {0, 0, 0}, {0, 0, 0}};
  bound.add({{0, 0.5}, amid}, {{2, 0.5}, amid}, 30);
  EXPECT_NEAR(bound.highest(), 30 / 2e-11, 1e-3);
}

TEST(FrequencyBound, GivenTwoSpringsAtTheSamePlaces_ThenTheirFrequenciesAddUpInTheSquare) {
  const std::vector<double> mass(4, 2e-11), rotary(4, 1e-12);
  contact::FrequencyBound bound(mass, rotary);
  const contact::Hold amid{0.5, 0.5, {0, 0, 0}, {0, 0, 0}};
  bound.add({{0, 0.5}, amid}, {{2, 0.5}, amid}, 30);
  bound.add({{0, 0.5}, amid}, {{2, 0.5}, amid}, 12);
  EXPECT_NEAR(bound.highest(), 42 / 2e-11, 1e-3);
}

TEST(FrequencyBound, GivenNoSpring_ThenItIsZero) {
  const std::vector<double> mass(2, 1e-11), rotary(2, 1e-12);
  EXPECT_EQ(contact::FrequencyBound(mass, rotary).highest(), 0);
}

}  // namespace
}  // namespace knitmech
