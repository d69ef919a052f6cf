#include "solve/selective_mass.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "../../support/beam_case.h"

namespace knitmech {
namespace {

constexpr std::size_t kNodes = 23;

/// Yarns of five nodes each, the last of three, with any masses.
beam::NodalInertia random_inertia(std::mt19937& random) {
  constexpr std::size_t chain = 5;
  std::uniform_real_distribution<double> mass(1, 3), relative(0, 20);
  beam::NodalInertia inertia;
  for (std::size_t i = 0; i < kNodes; ++i) {
    inertia.mass.push_back(mass(random));
    const bool ends = i % chain == chain - 1 || i == kNodes - 1;
    inertia.relative_mass.push_back(ends ? 0 : relative(random));
  }
  return inertia;
}

/// The mass matrix from its quadratic form, sum of m v^2 / 2 and b (v_b - v_a)^2 / 2.
Eigen::MatrixXd dense(const beam::NodalInertia& inertia) {
  const auto n = static_cast<Eigen::Index>(inertia.mass.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    matrix(i, i) += inertia.mass[static_cast<std::size_t>(i)];
    if (i + 1 == n) continue;
    Eigen::Matrix2d apart;
    apart << 1, -1, -1, 1;
    matrix.block<2, 2>(i, i) += inertia.relative_mass[static_cast<std::size_t>(i)] * apart;
  }
  return matrix;
}

/// Accelerations under forces, where `given` those themselves, by a dense solve.
Eigen::VectorXd accelerations(const Eigen::MatrixXd& mass, const Eigen::VectorXd& force, const Eigen::VectorXd& motion,
                              const std::vector<char>& given) {
  Eigen::MatrixXd matrix = mass;
  Eigen::VectorXd right = force;
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    if (given[static_cast<std::size_t>(i)] == 0) continue;
    matrix.row(i) = Eigen::VectorXd::Unit(force.size(), i).transpose();
    right[i] = motion[i];
  }
  return matrix.partialPivLu().solve(right);
}

/// Given motions: none in the first 50 trials, then of about every third node along y, and of as many across.
solve::GivenMotion random_motion(std::mt19937& random, int trial) {
  solve::GivenMotion given{std::vector<char>(kNodes), std::vector<char>(kNodes)};
  if (trial < 50) return given;
  std::bernoulli_distribution held(0.3);
  for (std::size_t i = 0; i < kNodes; ++i) {
    given.along[i] = held(random) ? 1 : 0;
    given.across[i] = held(random) ? 1 : 0;
  }
  return given;
}

model::NodalLoads loads_of(const Eigen::MatrixXd& force) {
  model::NodalLoads loads(kNodes);
  for (std::size_t i = 0; i < kNodes; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    loads.force.set(i, {force(row, 0), force(row, 1), force(row, 2)});
  }
  return loads;
}

/// What is shared out along one direction: the acceleration of each node, and the force on it from its neighbours.
void expect_accelerations(const solve::SelectiveMass& masses, const beam::NodalInertia& inertia,
                          const std::vector<double>& shared, const Eigen::VectorXd& expected) {
  const Eigen::VectorXd inertia_force = dense(inertia) * expected;
  for (std::size_t i = 0; i < kNodes; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(shared[i] / inertia.mass[i], expected[row], 1e-12) << "node " << i;
    const double of_neighbours = inertia_force[row] - inertia.mass[i] * expected[row];
    EXPECT_NEAR(masses.from_neighbours(i, shared), of_neighbours, 1e-11) << "node " << i;
  }
}

TEST(SelectiveMass, GivenForcesAndGivenMotions_ThenTheAccelerationsAreThoseOfADenseSolve) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    const beam::NodalInertia inertia = random_inertia(random);
    const solve::GivenMotion given = random_motion(random, trial);
    const Eigen::MatrixXd mass = dense(inertia);
    const Eigen::MatrixXd force = Eigen::MatrixXd::NullaryExpr(kNodes, 3, [&] { return normal(random); });
    model::NodalLoads loads = loads_of(force);
    const solve::SelectiveMass masses(inertia, given);
    if (trial % 2 == 0) {
      masses.share(loads);
    } else {
      masses.share(loads, base::ThreadTeam(3));
    }
    for (int direction = 0; direction < 3; ++direction) {
      const Eigen::VectorXd motion = force.col(direction).cwiseQuotient(mass.rowwise().sum());  // F = m a is given
      const std::vector<char>& held_here = direction == 1 ? given.along : given.across;
      const Eigen::VectorXd expected = accelerations(mass, force.col(direction), motion, held_here);
      const std::vector<double>& shared = direction == 0   ? loads.force.x
                                          : direction == 1 ? loads.force.y
                                                           : loads.force.z;
      expect_accelerations(masses, inertia, shared, expected);
    }
  }
}

TEST(SelectiveMass, GivenAForceOnOneNode_ThenTheMassThatItFeelsIsThatOfTheInverse) {
  std::mt19937 random(4);
  const beam::NodalInertia inertia = random_inertia(random);
  const solve::SelectiveMass masses(inertia, {std::vector<char>(kNodes), std::vector<char>(kNodes)});
  const Eigen::MatrixXd inverse = dense(inertia).inverse();
  for (std::size_t i = 0; i < kNodes; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(masses.felt()[i], 1 / inverse(row, row), 1e-12 * masses.felt()[i]);
  }
}

TEST(SelectiveMass, GivenNoRelativeMass_ThenForcesStayWhatTheyAre) {
  const beam::NodalInertia inertia{{1, 2}, {1, 1}, 0, {}};
  model::NodalLoads loads(2);
  loads.force.set(1, {3, 4, 5});
  solve::SelectiveMass(inertia, {std::vector<char>(2), std::vector<char>(2)}).share(loads);
  EXPECT_EQ(test::vector_at(loads.force, 1), Eigen::Vector3d(3, 4, 5));
}

/// Squares of the frequencies [1/s^2] of a chain of springs of the stiffness k along y on masses m, half of it at
/// either end, with relative masses b: ascending.
std::vector<double> chain_frequencies(double k, double m, double b, bool clamped) {
  constexpr std::size_t kChain = 21;
  beam::NodalInertia inertia{std::vector<double>(kChain, m), {}, 0, std::vector<double>(kChain, b)};
  inertia.mass.front() = inertia.mass.back() = 0.5 * m;
  inertia.relative_mass.back() = 0;
  solve::GivenMotion given{std::vector<char>(kChain), std::vector<char>(kChain)};
  given.along.front() = given.along.back() = clamped ? 1 : 0;
  const solve::SelectiveMass masses(inertia, given);
  Eigen::MatrixXd dynamic(kChain, kChain);
  for (std::size_t column = 0; column < kChain; ++column) {
    model::NodalLoads loads(kChain);
    for (const int side : {-1, 1}) {  // forces that hold one node displaced by one
      const std::size_t neighbour = column + static_cast<std::size_t>(side);
      if (neighbour >= kChain) continue;
      loads.force.y[column] += k;
      loads.force.y[neighbour] -= k;
    }
    if (clamped) loads.force.y.front() = loads.force.y.back() = 0;
    masses.share(loads);
    for (std::size_t i = 0; i < kChain; ++i) {
      dynamic(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(column)) = loads.force.y[i] / inertia.mass[i];
    }
  }
  if (clamped) dynamic = dynamic.block<kChain - 2, kChain - 2>(1, 1).eval();
  std::vector<double> squares;
  for (const std::complex<double> value : dynamic.eigenvalues()) squares.push_back(value.real());
  std::sort(squares.begin(), squares.end());
  return squares;
}

TEST(SelectiveMass, GivenAFreeAndAClampedChain_ThenItsFrequenciesAreThoseOfTheFormula) {
  // Standing waves in a chain, j half waves in n elements: w^2 = k mu / (m + b mu) with mu = 4 sin^2(pi j / (2 n)).
  const double k = 7, m = 2, b = 3;
  for (const bool clamped : {false, true}) {
    const std::vector<double> squares = chain_frequencies(k, m, b, clamped);
    const int first = clamped ? 1 : 0;
    ASSERT_EQ(squares.size(), clamped ? 19U : 21U);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const double mu = 4 * std::pow(std::sin(std::numbers::pi * (first + static_cast<int>(i)) / 40), 2);
      EXPECT_NEAR(squares[i], k * mu / (m + b * mu), 1e-10) << i;
    }
  }
}

}  // namespace
}  // namespace knitmech
