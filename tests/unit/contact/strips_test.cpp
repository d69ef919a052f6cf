#include "contact/strips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "../../support/beam_case.h"
#include "contact/constants.h"
#include "contact/normal_law.h"
#include "contact/yarn_contact.h"

namespace knitmech::contact {
namespace {

constexpr double kDiameter = 0.12;   // mm
constexpr double kStiffness = 16.0;  // N/mm

model::Model model_of(const std::vector<std::vector<Eigen::Vector3d>>& yarns) {
  model::Model model = test::yarns_through(yarns, test::section(19, 6, 0.017, 0.012, 1e-11, kDiameter));
  model.contact_stiffness = kStiffness;
  model.centreline = model::Centreline::smooth;
  return model;
}

/// Two yarns hooked into each other as tightly as they can be: each an arc about the other's tip.
/// \param radius of the arcs [mm]   \param apart distance of the tips [mm]
model::Model clasp(double radius, double apart, int n_elements) {
  std::vector<std::vector<Eigen::Vector3d>> yarns(2);
  for (int i = 0; i <= n_elements; ++i) {
    const double angle = 1.4 * (2.0 * i / n_elements - 1);
    const double side = radius * std::sin(angle);
    const double back = radius * (1 - std::cos(angle));
    yarns[0].emplace_back(side, 0, -back);
    yarns[1].emplace_back(0, side, -apart + back);
  }
  return model_of(yarns);
}

/// The energy by its definition, without any search.
double plain_energy(const model::Model& model, const model::State& state) {
  Centreline line(model);
  line.update(state, {}, 0);
  const YarnElements elements = make_yarn_elements(model);
  constexpr int kCuts = 120;
  std::array<std::vector<Vector3>, 2> points;
  std::array<std::vector<double>, 2> lengths;
  for (std::size_t a = 0; a < elements.n_nodes(); ++a) {
    if (elements.exists[a] == 0) continue;
    const auto yarn = static_cast<std::size_t>(elements.yarn[a]);
    for (int i = 0; i < kCuts; ++i) {
      points[yarn].push_back(combine(line.curve(a), hermite((i + 0.5) / kCuts)));
      lengths[yarn].push_back(elements.length[a] / kCuts);
    }
  }
  double energy = 0;
  for (std::size_t i = 0; i < points[0].size(); ++i) {
    for (std::size_t j = 0; j < points[1].size(); ++j) {
      const double distance = length(points[1][j] - points[0][i]);
      if (distance < kDiameter)
        energy += lengths[0][i] * lengths[1][j] * normal_energy(kDiameter - distance, kDiameter);
    }
  }
  return density_factor() * kStiffness / (kDiameter * kDiameter) * energy;
}

TEST(Strips, GivenATightClasp_ThenTheEnergyIsTheDoubleIntegralOfItsDefinition) {
  // Around the tips all places of one yarn are equally near to the other: no closest places to be integrated about.
  for (const double penetration : {0.004, 0.01, 0.02}) {
    const model::Model model = clasp(1.1 * kDiameter, kDiameter - penetration, 8);
    const model::State state = test::state_of(model);
    YarnContact contact(model);
    model::NodalLoads loads(model.nodes.size());
    contact.add_forces(state, 0.0, loads);
    const double expected = plain_energy(model, state);
    EXPECT_NEAR(contact.energy(), expected, 0.01 * expected) << penetration;
  }
}

TEST(Strips, GivenATightClasp_ThenTheLoadsAreTheDerivativesOfTheEnergy) {
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  const model::Model model = clasp(1.1 * kDiameter, 0.9 * kDiameter, 8);
  const model::State state = test::state_of(model);
  YarnContact contact(model);
  model::NodalLoads loads(model.nodes.size());
  contact.add_forces(state, 0.0, loads);
  ASSERT_GT(contact.n_contacts(), 4);
  for (int trial = 0; trial < 20; ++trial) {
    constexpr double kStep = 1e-7;
    model::State ahead = state;
    model::State behind = state;
    double power = 0;
    double size = 0;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      const double x = normal(random);
      const double y = normal(random);
      const Vector3 move{x, y, normal(random)};
      const double a = normal(random);
      const double b = normal(random);
      const Eigen::Vector3d turn(a, b, normal(random));
      ahead.position.add(i, kStep * move);
      behind.position.add(i, -kStep * move);
      test::set_rotation(ahead, i, test::turn(kStep * turn));
      test::set_rotation(behind, i, test::turn(-kStep * turn));
      const double part = dot(loads.force.at(i), move) + dot(loads.moment.at(i), {turn.x(), turn.y(), turn.z()});
      power += part;
      size += std::abs(part);
    }
    YarnContact more = contact;
    YarnContact less = contact;
    model::NodalLoads unused(model.nodes.size());
    more.add_forces(ahead, 0.0, unused);
    less.add_forces(behind, 0.0, unused);
    EXPECT_NEAR(power, -(more.energy() - less.energy()) / (2 * kStep), 1e-4 * size);
  }
}

/// A yarn wound once round a thick straight one, pressed into it by a penetration.
model::Model wound(double thick, double penetration, int n_elements, bool wound_first) {
  const double radius = 0.5 * (thick + kDiameter) - penetration;
  std::vector<Eigen::Vector3d> ring;
  for (int i = 0; i <= n_elements; ++i) {
    const double angle = 0.3 + 5.5 * i / n_elements;
    ring.emplace_back(0.013, radius * std::cos(angle), radius * std::sin(angle));
  }
  const auto axis = test::straight({-3, 0, 0}, {3, 0, 0}, 6);
  model::Model model = wound_first ? model_of({ring, axis}) : model_of({axis, ring});
  model.sections.push_back(test::section(19, 6, 0.017, 0.012, 1e-11, thick));
  const model::ModelYarn& range = model.yarns[wound_first ? 1 : 0];
  for (int i = range.first_node; i < range.first_node + 7; ++i) model.element_section[static_cast<std::size_t>(i)] = 1;
  return model;
}

TEST(Strips, GivenAYarnWoundRoundAThickOne_ThenItIsTheWoundOneThatIsCut_WhicheverComesFirst) {
  for (const bool wound_first : {false, true}) {
    const model::Model model = wound(1.0, 0.004, 24, wound_first);
    YarnContact contact(model);
    model::NodalLoads loads(model.nodes.size());
    contact.add_forces(test::state_of(model), 0.0, loads);
    // Spaced along the ring, which is 5.5 radii long.
    const double strip = kStripLength * 0.56;
    EXPECT_GT(contact.n_contacts(), 0.8 * 5.5 * 0.556 / strip);
    // The force of a length of the ring is the same everywhere.
    std::vector<double> per_length;
    for (const ContactPoint& point : contact.points()) per_length.push_back(point.load);
    std::sort(per_length.begin(), per_length.end());
    EXPECT_LT(per_length[per_length.size() * 9 / 10] / per_length[per_length.size() / 10], 1.1);
  }
}

}  // namespace
}  // namespace knitmech::contact
