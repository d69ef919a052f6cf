#include "beam/nodal_inertia.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>

#include "../../support/beam_case.h"
#include "beam/internal_force.h"

namespace knitmech {
namespace {

/// Highest frequency squared of a model by the eigenvalues of its stiffness, differentiated numerically from the loads.
double highest_eigenvalue(const model::Model& model, const beam::Elements& elements,
                          const beam::NodalInertia& inertia) {
  const auto n = static_cast<Eigen::Index>(model.nodes.size());
  const double h = 1e-7;
  Eigen::MatrixXd stiffness(6 * n, 6 * n);
  const auto loads_at = [&](const model::State& state) {
    beam::ElementWork work(model.nodes.size());
    model::NodalLoads loads(model.nodes.size());
    beam::set_internal_force(elements, state, 0.0, work, loads);
    Eigen::VectorXd all(6 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      all.segment<3>(6 * i) = test::vector_at(loads.force, static_cast<std::size_t>(i));
      all.segment<3>(6 * i + 3) = test::vector_at(loads.moment, static_cast<std::size_t>(i));
    }
    return all;
  };
  for (Eigen::Index column = 0; column < 6 * n; ++column) {
    Eigen::VectorXd difference = Eigen::VectorXd::Zero(6 * n);
    for (const double sign : {1.0, -1.0}) {
      model::State state = test::state_of(model);
      const auto node = static_cast<std::size_t>(column / 6);
      const Eigen::Vector3d unit = sign * h * Eigen::Vector3d::Unit(column % 3);
      if (column % 6 < 3) {
        state.position.add(node, {unit.x(), unit.y(), unit.z()});
      } else {
        test::set_rotation(state, node, test::turn(unit));
      }
      difference -= sign * loads_at(state);
    }
    stiffness.col(column) = difference / (2 * h);
  }
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(6 * n, 6 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    mass.diagonal().segment<3>(6 * i).array() += inertia.mass[static_cast<std::size_t>(i)];
    mass.diagonal().segment<3>(6 * i + 3).setConstant(inertia.rotary[static_cast<std::size_t>(i)]);
    const double relative = inertia.relative_mass_at(static_cast<std::size_t>(i));
    if (relative == 0) continue;
    for (Eigen::Index k = 6 * i; k < 6 * i + 3; ++k) {
      mass(k, k) += relative;
      mass(k + 6, k + 6) += relative;
      mass(k, k + 6) = mass(k + 6, k) = -relative;
    }
  }
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (stiffness + stiffness.transpose()), mass,
                                                                   Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

std::vector<Eigen::Vector3d> arc(double radius, double length, int n_elements) {
  std::vector<Eigen::Vector3d> nodes;
  for (int i = 0; i <= n_elements; ++i) {
    const double angle = length * i / (n_elements * radius);
    nodes.emplace_back(radius * std::sin(angle), radius * std::cos(angle), 0.05 * i);
  }
  return nodes;
}

TEST(NodalInertia, GivenMeshesFromSlenderToStout_ThenTheBoundHoldsAndIsTight) {
  for (const double element : {1.0, 0.5, 0.2, 0.1, 0.05}) {
    const model::Model model =
        test::yarns_through({arc(1.1, 8 * element, 8)}, test::section(19.2265, 6.17, 0.0173039, 0.0124488, 1.29e-11));
    const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
    const beam::NodalInertia inertia = beam::lump_inertia(elements, 1.0);
    const double highest = highest_eigenvalue(model, elements, inertia);
    EXPECT_LE(highest, inertia.highest_frequency_squared * (1 + 1e-5)) << "element " << element;
    EXPECT_GE(highest, inertia.highest_frequency_squared * 0.6) << "element " << element;
  }
}

TEST(NodalInertia, GivenAFinestLength_ThenTheFrequencyIsTheSameForEveryMeshFinerThanItAndTheBoundHolds) {
  const double finest = 0.6;
  for (const double element : {0.4, 0.2, 0.1}) {
    const model::Model model = test::yarns_through({test::straight({0, 0, 0}, {8 * element, 0, 0}, 8)},
                                                   test::section(19.2265, 6.17, 0.0173039, 0.0124488, 1.29e-11));
    const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
    const beam::NodalInertia inertia = beam::lump_inertia(elements, 1.0, finest);
    // As of a chain of lumped masses with elements of that length: w = 2 c / d.
    const double of_chain = 4 * 19.2265 / (1.29e-11 * finest * finest);
    EXPECT_NEAR(inertia.highest_frequency_squared, of_chain, 1e-9 * of_chain) << "element " << element;
    const double highest = highest_eigenvalue(model, elements, inertia);
    EXPECT_LE(highest, of_chain * (1 + 1e-5)) << "element " << element;
    EXPECT_GE(highest, of_chain * 0.9) << "element " << element;
    EXPECT_NEAR(std::accumulate(inertia.mass.begin(), inertia.mass.end(), 0.0), 8 * element * 1.29e-11, 1e-20);
  }
}

TEST(NodalInertia, GivenAFinestLengthBelowThatOfTheElements_ThenThereIsNoRelativeMass) {
  const model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {2, 0, 0}, 5)}, test::section(19.0, 6.1, 0.0173, 0.0124, 1.3e-11));
  const beam::Elements elements = beam::make_elements(model, 1.0, 0.0);
  const beam::NodalInertia inertia = beam::lump_inertia(elements, 1e4, 0.3);
  const beam::NodalInertia lumped = beam::lump_inertia(elements, 1e4);
  for (const double relative : inertia.relative_mass) EXPECT_EQ(relative, 0);
  EXPECT_EQ(inertia.rotary, lumped.rotary);
  EXPECT_EQ(inertia.highest_frequency_squared, lumped.highest_frequency_squared);
}

TEST(NodalInertia, GivenAYarn_ThenItsMassIsKeptAndScaled) {
  const model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {2, 0, 0}, 5)}, test::section(19.0, 6.1, 0.0173, 0.0124, 1.3e-11));
  const beam::NodalInertia inertia = beam::lump_inertia(beam::make_elements(model, 1.0, 0.0), 1e4);
  EXPECT_NEAR(std::accumulate(inertia.mass.begin(), inertia.mass.end(), 0.0), 2 * 1.3e-11 * 1e4, 1e-20);
  // The axial wave crosses an element in L0 / c = L0 sqrt(rho A / EA): the stable step of a chain of lumped masses.
  const double crossing = 0.4 * std::sqrt(1.3e-11 * 1e4 / 19.0);
  EXPECT_NEAR(2 / std::sqrt(inertia.highest_frequency_squared), crossing, 1e-12 * crossing);
}

}  // namespace
}  // namespace knitmech
