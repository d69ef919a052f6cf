#include "contact/yarn_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "../../support/beam_case.h"
#include "contact/constants.h"
#include "contact/normal_law.h"

namespace knitmech::contact {
namespace {

constexpr double kDiameter = 0.12;   // mm
constexpr double kStiffness = 16.0;  // N/mm

model::Model model_of(const std::vector<std::vector<Eigen::Vector3d>>& yarns, double friction) {
  model::Model model = test::yarns_through(yarns, test::section(19, 6, 0.017, 0.012, 1e-11, kDiameter));
  model.friction = friction;
  model.contact_stiffness = kStiffness;
  model.centreline = model::Centreline::chords;
  return model;
}

model::NodalLoads loads_of(YarnContact& contact, const model::State& state, double step = 0.0) {
  model::NodalLoads loads(state.position.size());
  contact.add_forces(state, step, loads);
  return loads;
}

/// Two yarns that cross at right angles, one above the other, at the given distance of their centrelines.
model::Model crossing(double distance, double friction) {
  return model_of(
      {test::straight({-1, 0, 0}, {1, 0.1, 0}, 3), test::straight({0.1, -1, distance}, {0, 1, distance}, 3)}, friction);
}

TEST(YarnContact, GivenTwoCrossingYarnsThatOverlap_ThenEachIsPushedAwayByTheNormalLaw) {
  const double penetration = 0.01;
  const model::Model model = crossing(kDiameter - penetration, 0.0);
  YarnContact contact(model);
  const model::NodalLoads loads = loads_of(contact, test::state_of(model));
  const double expected = kStiffness * normal_force(penetration, kDiameter);
  double lower = 0;
  double upper = 0;
  for (std::size_t i = 0; i < 4; ++i) lower += loads.force.z[i];
  for (std::size_t i = 4; i < 8; ++i) upper += loads.force.z[i];
  EXPECT_NEAR(upper, expected, 1e-12);
  EXPECT_NEAR(lower, -expected, 1e-12);
  EXPECT_EQ(contact.n_contacts(), 1);
  EXPECT_NEAR(contact.largest_penetration(), penetration, 1e-14);
  EXPECT_NEAR(contact.energy(), kStiffness * normal_energy(penetration, kDiameter), 1e-15);
}

TEST(YarnContact, GivenTwoYarnsThatDoNotTouch_ThenThereIsNoForce) {
  const model::Model model = crossing(1.001 * kDiameter, 0.3);
  YarnContact contact(model);
  const model::NodalLoads loads = loads_of(contact, test::state_of(model));
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(loads.force.z[i], 0.0);
}

TEST(YarnContact, GivenAMovingYarn_ThenThePullOnItIsMuTimesThePressureAndTheLossIsItsWork) {
  const double mu = 0.3;
  const double penetration = 0.01;
  const model::Model model = crossing(kDiameter - penetration, mu);
  YarnContact contact(model);
  model::State state = test::state_of(model);
  for (std::size_t i = 4; i < 8; ++i) state.velocity.x[i] = 2.0;  // mm/s
  const double step = 0.05;
  const model::NodalLoads loads = loads_of(contact, state, step);
  const double pressure = kStiffness * normal_force(penetration, kDiameter);
  double pull = 0;
  for (std::size_t i = 4; i < 8; ++i) pull += loads.force.x[i];
  EXPECT_NEAR(pull, -mu * pressure, 1e-12);
  const double elastic = mu * pressure / (kStickStiffness * kStiffness);
  EXPECT_NEAR(contact.friction_loss(), mu * pressure * (2.0 * step - elastic), 1e-12);
}

TEST(YarnContact, GivenRandomTangles_ThenTheLoadsAreTheNegativeDerivativeOfTheEnergyAndInBalance) {
  std::mt19937 random(23);
  std::normal_distribution<double> normal(0, 0.25);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<std::vector<Eigen::Vector3d>> yarns(3);
    for (auto& yarn : yarns) {
      for (int i = 0; i <= 8; ++i) {
        const double y = normal(random);
        yarn.emplace_back(-2 + 0.5 * i, y, normal(random));
      }
    }
    const model::Model model = model_of(yarns, 0.0);
    YarnContact contact(model);
    const model::State state = test::state_of(model);
    const model::NodalLoads loads = loads_of(contact, state);
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    const double h = 1e-7;
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
      const Eigen::Vector3d nodal = test::vector_at(loads.force, node);
      force += nodal;
      moment += model.nodes[node].cross(nodal);
      for (int axis = 0; axis < 3; ++axis) {
        std::array<double, 2> energy{};
        for (const std::size_t side : {0U, 1U}) {
          model::State moved = state;
          const Eigen::Vector3d shift = (side == 0 ? h : -h) * Eigen::Vector3d::Unit(axis);
          moved.position.add(node, {shift.x(), shift.y(), shift.z()});
          YarnContact fresh(model);
          loads_of(fresh, moved);
          energy[side] = fresh.energy();
        }
        EXPECT_NEAR(nodal[axis], -(energy[0] - energy[1]) / (2 * h), 1e-5 * (1 + nodal.norm()));
      }
    }
    EXPECT_LT(force.norm(), 1e-11);
    EXPECT_LT(moment.norm(), 1e-11);
  }
}

TEST(YarnContact, GivenYarnsThatMoveFar_ThenTheNeighbourListIsRenewedInTime) {
  const model::Model model = crossing(5.0, 0.0);
  YarnContact contact(model);
  model::State state = test::state_of(model);
  for (int i = 0; i <= 490; ++i) {
    loads_of(contact, state);
    for (std::size_t node = 4; node < 8; ++node) state.position.z[node] -= 0.01;
  }
  EXPECT_EQ(contact.n_contacts(), 1);
  EXPECT_GT(contact.searches(), 10);
  EXPECT_LT(contact.searches(), 491);
}

TEST(YarnContact, GivenAYarnThatIsPutOnTheOtherSide_ThenTheLostCrossingIsReportedWithItsPlace) {
  const model::Model model = crossing(0.01, 0.0);
  YarnContact contact(model);
  model::State state = test::state_of(model);
  loads_of(contact, state);
  EXPECT_FALSE(contact.lost_crossing().has_value());
  for (std::size_t node = 4; node < 8; ++node) state.position.z[node] = -0.01;
  loads_of(contact, state);
  ASSERT_TRUE(contact.lost_crossing().has_value());
  EXPECT_EQ(contact.lost_crossing()->first, 1);
  EXPECT_EQ(contact.lost_crossing()->second, 5);
}

TEST(YarnContact, GivenAContact_ThenItsStiffnessOverTheMassBoundsTheFrequency) {
  const double penetration = 0.01;
  const model::Model model = crossing(kDiameter - penetration, 0.0);
  YarnContact contact(model);
  loads_of(contact, test::state_of(model));
  const double mass = 2e-9;
  // Both yarns rigid, each with the mass of its nodes: w^2 = k (1 / m_a + 1 / m_b), of which the bound must not fall
  // short.
  const double tangent = kStiffness * normal_tangent(penetration, kDiameter);
  std::vector<double> even(16, 0.0);  // displacements alike, no rotations
  std::fill_n(even.begin(), 8, 1.0);
  std::vector<double> image;
  contact.springs().multiply(even, image);
  EXPECT_GE(*std::max_element(image.begin(), image.begin() + 8) / mass, tangent * 2 / (4 * mass));
}

TEST(YarnContact, GivenACrossingThatMovesOnToElementsThatHadMovedLess_ThenItGoesOnPressing) {
  // Given a yarn that crosses another just behind its node 5, hardly apart, while node 7 has shaken by millimetres.
  const double gap = 0.003;
  const double height = kDiameter + gap;
  model::Model model = model_of(
      {test::straight({0, 0, 0}, {10, 0, 0}, 10), test::straight({5.002, -4.5, height}, {5.002, 5.5, height}, 10)},
      0.0);
  model.centreline = model::Centreline::smooth;
  YarnContact contact(model);
  model::State state = test::state_of(model);
  const auto move = [&](const Vector3& lower, const Vector3& upper) {
    for (std::size_t i = 0; i < 11; ++i) state.position.add(i, lower);
    for (std::size_t i = 11; i < 22; ++i) state.position.add(i, upper);
    double up = 0;
    const model::NodalLoads loads = loads_of(contact, state);
    for (std::size_t i = 11; i < 22; ++i) up += loads.force.z[i];
    return up;
  };
  for (int i = 0; i < 40; ++i) {
    state.position.z[7] += i % 2 == 0 ? -0.05 : 0.05;
    ASSERT_EQ(move({0, 0, 0}, {0, 0, 0}), 0);
  }
  // When the yarns come nearer by twice the gap,
  const double force = move({0, 0, gap}, {0, 0, -gap});
  ASSERT_GT(force, 0);
  // and then slide until they cross before the node, they press on, then and later.
  EXPECT_NEAR(move({0.002, 0, 0}, {-0.002, 0, 0}), force, 0.01 * force);
  EXPECT_NEAR(move({0, 0, 0}, {0, 0, 0}), force, 0.01 * force);
}

}  // namespace
}  // namespace knitmech::contact
