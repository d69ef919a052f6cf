#include "contact/springs.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

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

constexpr std::size_t kNodes = 6;

/// Gershgorin's bound of the square of the highest frequency: the largest row sum of |K|, scaled with the inertia.
double bound_of(const contact::Springs& springs, const Inertia& inertia) {
  std::vector<double> masses = inertia.mass;
  masses.insert(masses.end(), inertia.rotary.begin(), inertia.rotary.end());
  std::vector<double> d;
  d.reserve(masses.size());
  for (const double mass : masses) d.push_back(1 / std::sqrt(mass));
  std::vector<double> image;
  springs.multiply(d, image);
  double highest = 0;
  for (std::size_t i = 0; i < d.size(); ++i) highest = std::max(highest, image[i] / (masses[i] * d[i]));
  return highest;
}

Vector3 random_vector(std::mt19937& random, double size) {
  std::normal_distribution<double> normal(0, size);
  const double x = normal(random);
  const double y = normal(random);
  return {x, y, normal(random)};
}

contact::Springs::End random_end(std::mt19937& random) {
  std::uniform_int_distribution<int> element(0, kNodes - 2);
  const double share = std::uniform_real_distribution<double>(0, 1)(random);
  return {{element(random), share}, {1 - share, share, random_vector(random, 0.1), random_vector(random, 0.1)}};
}

/// Motion along a direction of a place that hangs on its nodes as `end` says: one entry per degree of freedom.
Eigen::VectorXd row_of(const contact::Springs::End& end, const Eigen::Vector3d& direction) {
  const auto eigen = [](Vector3 v) { return Eigen::Vector3d(v.x, v.y, v.z); };
  Eigen::VectorXd row = Eigen::VectorXd::Zero(6 * kNodes);
  const Eigen::Index first = Eigen::Index{6} * end.place.element;
  row.segment<3>(first) = end.hold.start * direction;
  row.segment<3>(first + 3) = eigen(end.hold.start_arm).cross(direction);
  row.segment<3>(first + 6) = end.hold.end * direction;
  row.segment<3>(first + 9) = eigen(end.hold.end_arm).cross(direction);
  return row;
}

TEST(Springs, GivenAnySpringsBetweenAnyPlaces_ThenNoEigenvalueIsHigher) {
  std::mt19937 random(5);
  double closest = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Inertia inertia = random_inertia(kNodes, random);
    contact::Springs springs;
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6 * kNodes, 6 * kNodes);
    for (int spring = 0; spring <= trial % 4; ++spring) {
      const contact::Springs::End first = random_end(random);
      const contact::Springs::End second = random_end(random);
      const Vector3 along = random_vector(random, 1);
      const Eigen::Vector3d direction = Eigen::Vector3d(along.x, along.y, along.z).normalized();
      const Eigen::VectorXd row = row_of(first, direction) - row_of(second, direction);
      stiffness += 16 * row * row.transpose();
      springs.add(first, second, 16);
    }
    Eigen::VectorXd scale(6 * kNodes);
    for (std::size_t i = 0; i < kNodes; ++i) {
      scale.segment<3>(static_cast<Eigen::Index>(6 * i)).setConstant(1 / std::sqrt(inertia.mass[i]));
      scale.segment<3>(static_cast<Eigen::Index>(6 * i + 3)).setConstant(1 / std::sqrt(inertia.rotary[i]));
    }
    const Eigen::MatrixXd dynamic = scale.asDiagonal() * stiffness * scale.asDiagonal();
    const double highest =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dynamic, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
    const double bound = bound_of(springs, inertia);
    EXPECT_LE(highest, bound * (1 + 1e-9)) << "trial " << trial;
    closest = std::max(closest, highest / bound);
  }
  EXPECT_GT(closest, 0.5);
}

TEST(Springs, GivenOneSpringOnTheChordsBetweenEqualNodes_ThenItIsExact) {
  // Amid both elements, half a node's weight each: four equal entries of K / (4 m) in every row, so w^2 = 4 K / (4 m).
  const Inertia inertia{std::vector<double>(4, 2e-11), std::vector<double>(4, 1e-12)};
  contact::Springs springs;
  const contact::Hold amid{0.5, 0.5, {0, 0, 0}, {0, 0, 0}};
  springs.add({{0, 0.5}, amid}, {{2, 0.5}, amid}, 30);
  EXPECT_NEAR(bound_of(springs, inertia), 30 / 2e-11, 1e-3);
}

TEST(Springs, GivenTwoSpringsAtTheSamePlaces_ThenTheirFrequenciesAddUpInTheSquare) {
  const Inertia inertia{std::vector<double>(4, 2e-11), std::vector<double>(4, 1e-12)};
  contact::Springs springs;
  const contact::Hold amid{0.5, 0.5, {0, 0, 0}, {0, 0, 0}};
  springs.add({{0, 0.5}, amid}, {{2, 0.5}, amid}, 30);
  springs.add({{0, 0.5}, amid}, {{2, 0.5}, amid}, 12);
  EXPECT_NEAR(bound_of(springs, inertia), 42 / 2e-11, 1e-3);
}

TEST(Springs, GivenNoSpring_ThenItIsZero) {
  EXPECT_EQ(bound_of({}, {std::vector<double>(2, 1e-11), std::vector<double>(2, 1e-12)}), 0);
}

}  // namespace
}  // namespace knitmech
