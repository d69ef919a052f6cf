#include "solve/contact_frequency.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "contact/springs.h"

namespace knitmech {
namespace {

constexpr std::size_t kNodes = 24;  // two yarns of twelve

/// A contact: a spring along a direction between a place on the first yarn and one on the second.
struct Spring {
  contact::Springs::End first, second;
  Eigen::Vector3d direction;
};

class RandomContacts {
 public:
  RandomContacts(unsigned seed, int n_springs, bool is_lumped) : random_(seed) {
    std::uniform_real_distribution<double> mass(1, 1.5);
    for (std::size_t i = 0; i < kNodes; ++i) {
      inertia.mass.push_back(mass(random_));
      inertia.rotary.push_back(0.1 * mass(random_));
      if (!is_lumped) inertia.relative_mass.push_back(i == 11 || i + 1 == kNodes ? 0 : 2 * mass(random_));
    }
    for (int k = 0; k < n_springs; ++k) {
      springs_.push_back({end_on(0), end_on(12), Eigen::Vector3d(normal(), normal(), normal()).normalized()});
    }
  }

  [[nodiscard]] double bound() const {
    contact::Springs springs;
    for (const Spring& spring : springs_) springs.add(spring.first, spring.second, 16);
    const std::vector<char> free(kNodes);
    return solve::highest_frequency_squared(springs, inertia, solve::SelectiveMass(inertia, {free, free}));
  }

  /// The largest eigenvalue of the stiffness over the mass matrix.
  [[nodiscard]] double reference() const {
    const Eigen::Index n = 6 * kNodes;
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
    for (const Spring& spring : springs_) {
      const Eigen::VectorXd row = row_of(spring.second, spring.direction) - row_of(spring.first, spring.direction);
      stiffness += 16 * row * row.transpose();
    }
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i < kNodes; ++i) {
      const auto at = static_cast<Eigen::Index>(6 * i);
      mass.diagonal().segment<3>(at).array() += inertia.mass[i];
      mass.diagonal().segment<3>(at + 3).array() += inertia.rotary[i];
      const double relative = inertia.relative_mass_at(i);
      if (relative == 0) continue;
      const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity();
      mass.block<3, 3>(at, at) += relative * unit;
      mass.block<3, 3>(at + 6, at + 6) += relative * unit;
      mass.block<3, 3>(at, at + 6) -= relative * unit;
      mass.block<3, 3>(at + 6, at) -= relative * unit;
    }
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness, mass, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
  }

  beam::NodalInertia inertia;

 private:
  double normal() { return std::normal_distribution<double>()(random_); }
  contact::Springs::End end_on(int first_node) {
    const int element = first_node + std::uniform_int_distribution<int>(0, 10)(random_);
    const double share = std::uniform_real_distribution<double>(0, 1)(random_);
    const auto arm = [&] { return Vector3{0.05 * normal(), 0.05 * normal(), 0.05 * normal()}; };
    return {{element, share}, {1 - share, share, arm(), arm()}};
  }
  /// Motion of a place along a direction: one entry per degree of freedom.
  static Eigen::VectorXd row_of(const contact::Springs::End& end, const Eigen::Vector3d& direction) {
    const auto eigen = [](Vector3 v) { return Eigen::Vector3d(v.x, v.y, v.z); };
    Eigen::VectorXd row = Eigen::VectorXd::Zero(6 * kNodes);
    const Eigen::Index at = Eigen::Index{6} * end.place.element;
    row.segment<3>(at) = end.hold.start * direction;
    row.segment<3>(at + 3) = eigen(end.hold.start_arm).cross(direction);
    row.segment<3>(at + 6) = end.hold.end * direction;
    row.segment<3>(at + 9) = eigen(end.hold.end_arm).cross(direction);
    return row;
  }

  std::mt19937 random_;
  std::vector<Spring> springs_;
};

TEST(ContactFrequency, GivenAnyContactsBetweenYarnsWithRelativeMass_ThenNoEigenvalueIsHigherAndTheBoundIsNotFar) {
  for (unsigned trial = 0; trial < 60; ++trial) {
    const RandomContacts contacts(trial, 1 + static_cast<int>(trial % 6), false);
    const double highest = contacts.reference();
    const double bound = contacts.bound();
    EXPECT_LE(highest, bound * (1 + 1e-9)) << "trial " << trial;
    // One contact is met nearly exactly; several in different directions count as if they had the same.
    EXPECT_GE(highest, (trial % 6 == 0 ? 0.8 : 0.4) * bound) << "trial " << trial;
  }
}

TEST(ContactFrequency, GivenTheSameContactsOnLumpedMasses_ThenTheBoundIsThatOfTheRowsAndHigher) {
  const RandomContacts selective(7, 3, false);
  const RandomContacts lumped(7, 3, true);
  EXPECT_LE(lumped.reference(), lumped.bound() * (1 + 1e-9));
  EXPECT_LT(selective.bound(), lumped.bound());
}

TEST(ContactFrequency, GivenNoContact_ThenItIsZero) {
  EXPECT_EQ(RandomContacts(1, 0, false).bound(), 0);
  EXPECT_EQ(RandomContacts(1, 0, true).bound(), 0);
}

}  // namespace
}  // namespace knitmech
