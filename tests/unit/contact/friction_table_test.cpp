#include "contact/friction_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../../support/beam_case.h"
#include "contact/yarn_contact.h"

namespace knitmech::contact {
namespace {

model::Model of_three_kinds(const std::vector<model::PairFriction>& pairs) {
  model::Model model;
  model.sections.resize(3);
  model.friction = 0.3;
  model.pair_friction = pairs;
  return model;
}

TEST(FrictionTable, GivenNoPairs_ThenAllYarnsHaveTheFrictionOfTheModel) {
  const FrictionTable table(of_three_kinds({}));
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) EXPECT_EQ(table.between(a, b), 0.3) << a << " on " << b;
  }
}

TEST(FrictionTable, GivenPairsInAnyOrder_ThenTheyHoldBothWaysAndTheOthersKeepTheFrictionOfTheModel) {
  const FrictionTable table(of_three_kinds({{2, 0, 0.1}, {1, 1, 0.5}, {1, 2, 0.0}}));
  constexpr std::array<std::array<double, 3>, 3> kExpected = {{{0.3, 0.3, 0.1}, {0.3, 0.5, 0.0}, {0.1, 0.0, 0.3}}};
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      EXPECT_EQ(table.between(static_cast<int>(a), static_cast<int>(b)), kExpected[a][b]) << a << " on " << b;
    }
  }
}

constexpr std::array<std::array<double, 2>, 2> kFriction = {{{0.15, 0.4}, {0.4, 0.25}}};
constexpr std::array<double, 2> kDiameter = {0.12, 0.1};  // mm, of the two kinds

/// Two yarns along x, one of each kind, under two along y, one of each kind: four crossings with the same penetration
/// [mm]. Yarn 0 and 1 lie below, 2 and 3 above; yarns 0 and 2 are of the first kind.
model::Model two_kinds(model::Centreline centreline, double penetration) {
  const double thinner = 0.5 * (kDiameter[0] - kDiameter[1]);
  const double above = kDiameter[0] - penetration;
  model::Model model = test::yarns_through(
      {test::straight({-2, -1, 0}, {2, -1, 0}, 9),  //
       test::straight({-2, 1, thinner}, {2, 1, thinner}, 9), test::straight({-1, -2, above}, {-1, 2, above}, 9),
       test::straight({1, -2, above - thinner}, {1, 2, above - thinner}, 9)},
      test::section(19, 6, 0.017, 0.012, 1e-11, kDiameter[0]));
  model.sections.push_back(test::section(19, 6, 0.017, 0.012, 1e-11, kDiameter[1]));
  for (const std::size_t yarn : {1U, 3U}) {
    std::fill_n(model.element_section.begin() + model.yarns[yarn].first_node, model.yarns[yarn].n_nodes, 1);
  }
  model.friction = kFriction[0][1];
  model.pair_friction = {{0, 0, kFriction[0][0]}, {1, 1, kFriction[1][1]}};
  model.contact_stiffness = 16;
  model.centreline = centreline;
  return model;
}

std::size_t first_of(const model::ModelYarn& yarn) {
  return static_cast<std::size_t>(yarn.first_node);
}

/// The node behind the last one of a yarn.
std::size_t end_of(const model::ModelYarn& yarn) {
  const int end = yarn.first_node + yarn.n_nodes;
  return static_cast<std::size_t>(end);
}

/// Total force on a yarn [N].
Eigen::Vector3d force_on(const model::Model& model, const model::NodalLoads& loads, std::size_t yarn) {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (std::size_t i = first_of(model.yarns[yarn]); i < end_of(model.yarns[yarn]); ++i) {
    force += test::vector_at(loads.force, i);
  }
  return force;
}

/// Slides all yarns above along x, far beyond their elastic slip.
void slide(const model::Model& model, YarnContact& contact, model::NodalLoads& loads) {
  model::State state = test::state_of(model);
  for (std::size_t i = first_of(model.yarns[2]); i < model.nodes.size(); ++i) state.velocity.x[i] = 2.0;  // mm/s
  contact.add_forces(state, 0.05, loads);
}

class TwoKinds : public testing::TestWithParam<model::Centreline> {};

TEST_P(TwoKinds, GivenYarnsThatSlideOnTwoKinds_ThenTheFrictionOfEachContactIsThatOfItsPairTimesItsPressure) {
  for (const double penetration : {0.0015, 0.005}) {
    const model::Model model = two_kinds(GetParam(), penetration);
    YarnContact contact(model);
    model::NodalLoads loads(model.nodes.size());
    slide(model, contact, loads);
    const std::vector<ContactPoint> points = contact.points();
    ASSERT_EQ(points.size(), 4U);
    std::array<Eigen::Vector3d, 4> expected;
    expected.fill(Eigen::Vector3d::Zero());
    for (const ContactPoint& point : points) {
      const auto below = static_cast<std::size_t>(point.first.element / 10);  // ten nodes to a yarn
      const auto above = static_cast<std::size_t>(point.second.element / 10);
      ASSERT_LT(below, 2U);
      ASSERT_GE(above, 2U);
      const Eigen::Vector3d force(-kFriction[below][above - 2] * point.load, 0, point.load);
      EXPECT_GT(point.load, 0.01) << "N";
      EXPECT_NEAR(point.friction_force().x, force.x(), 1e-12);
      EXPECT_TRUE(point.stick.slips);
      expected[above] += force;
      expected[below] -= force;
    }
    for (std::size_t yarn = 0; yarn < 4; ++yarn) {
      EXPECT_NEAR((force_on(model, loads, yarn) - expected[yarn]).norm(), 0, 1e-12) << "yarn " << yarn;
    }
  }
}

TEST_P(TwoKinds, GivenOneCrossing_ThenThePullOnTheSlidingYarnIsMuOfItsPairTimesThePressureOnIt) {
  for (const std::size_t below : {0U, 1U}) {
    for (const std::size_t above : {0U, 1U}) {
      // Each crossing on its own: the other two yarns are taken out of reach.
      model::Model model = two_kinds(GetParam(), 0.0015);
      for (const std::size_t yarn : {1 - below, 3 - above}) {
        for (std::size_t i = first_of(model.yarns[yarn]); i < end_of(model.yarns[yarn]); ++i) {
          model.nodes[i].z() += yarn < 2 ? -9 : 9;
        }
      }
      YarnContact contact(model);
      model::NodalLoads loads(model.nodes.size());
      slide(model, contact, loads);
      const Eigen::Vector3d force = force_on(model, loads, 2 + above);
      EXPECT_GT(force.z(), 0.01) << "N";
      EXPECT_NEAR(force.x(), -kFriction[below][above] * force.z(), 1e-12) << below << " under " << above;
      EXPECT_NEAR(force.y(), 0, 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothCentrelines, TwoKinds,
                         testing::Values(model::Centreline::chords, model::Centreline::smooth),
                         [](const testing::TestParamInfo<model::Centreline>& tested) {
                           return tested.param == model::Centreline::smooth ? "Smooth" : "Chords";
                         });

}  // namespace
}  // namespace knitmech::contact
