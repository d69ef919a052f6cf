// Whole tests with a measured curve and with yarns that break.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../support/pulled_yarn.h"
#include "../model/example_case.h"
#include "model/build_model.h"
#include "results/quality.h"
#include "solve/simulate.h"

namespace knitmech {
namespace {

constexpr double kLength = test::kPulledLength;

const yarn::AxialLaw& measured() {
  static const yarn::AxialLaw law({{0, 0}, {0.05, 0.9}, {0.1, 1.2}, {0.2, 2.6}});
  return law;
}

/// A straight yarn along y in ten elements, pulled slowly at its end. Element 4 is of section 1.
model::Model pulled_yarn(double strain) {
  model::Model model = test::pulled_yarn(measured().slope_at_zero(), strain, 20, 0.01);
  model.sections.push_back(model.sections.front());
  model.element_section[4] = 1;
  return model;
}

struct Heard {
  std::vector<model::HistoryRow> rows;
  std::vector<model::Frame> frames;
  model::RunOutcome outcome;

  Heard(const model::Model& model, int history_points, double mass_scaling = 100) {
    solve::SimulationSettings settings;
    settings.mass_scaling = mass_scaling;
    settings.history_points = history_points;
    outcome = solve::simulate(model, settings,
                              {[this](const model::HistoryRow& row) { rows.push_back(row); },
                               [this](const model::Frame& frame) { frames.push_back(frame); },
                               {}});
  }
  /// Largest energy that is missing, over the final work [-].
  [[nodiscard]] double largest_imbalance() const {
    double largest = 0;
    for (const model::HistoryRow& row : rows) largest = std::max(largest, std::abs(results::energy_residual(row)));
    return largest / rows.back().external_work;
  }
};

model::Model with_law(model::Model model) {
  model.axial_laws.emplace(0, measured());
  model.axial_laws.emplace(1, measured());
  return model;
}

/// Linear, with a weak place in the middle: it breaks at 1.5 N.
model::Model with_weak_place(model::OnBreak on_break) {
  model::Model model = pulled_yarn(0.12);
  model.strengths = {{1, 1.5}};
  model.test.on_break = on_break;
  return model;
}

TEST(MeasuredCurve, GivenAYarnThatIsPulled_ThenTheGripFeelsTheCurve) {
  // Reference: the law at the strain of the row. The curve bends little within a row, but twice sharply near its
  // points; 1 % bears that and the waves in the yarn.
  const Heard heard(with_law(pulled_yarn(0.25)), 100);
  ASSERT_EQ(heard.outcome.status, model::RunStatus::completed) << heard.outcome.reason;
  for (const double strain : {0.02, 0.05, 0.08, 0.1, 0.15, 0.2, 0.25}) {
    const auto row = std::ranges::find_if(heard.rows, [&](const auto& r) { return r.strain >= strain - 1e-9; });
    ASSERT_NE(row, heard.rows.end());
    const double expected = measured().force(row->strain);
    EXPECT_NEAR(row->force_top, expected, 0.01 * expected) << "at " << strain;
    EXPECT_NEAR(row->force_bottom, expected, 0.01 * expected) << "at " << strain;
  }
  EXPECT_NEAR(heard.frames.back().axial_force[7], measured().force(0.25), 0.01 * measured().force(0.25));
}

TEST(MeasuredCurve, GivenAYarnThatIsPulled_ThenTheEnergiesBalanceAndAreThoseOfTheCurve) {
  const Heard heard(with_law(pulled_yarn(0.25)), 50);
  EXPECT_LT(heard.largest_imbalance(), 1e-3);
  const double expected = kLength * measured().energy(0.25);
  EXPECT_NEAR(heard.rows.back().internal_energy, expected, 5e-3 * expected);
  EXPECT_NEAR(heard.rows.back().external_work, expected, 1e-2 * expected);
}

TEST(Break, GivenStop_ThenTheTestEndsAsCompletedWithinAStepOfTheStrength) {
  const Heard heard(with_weak_place(model::OnBreak::stop), 50);
  const double strain = 1.5 / measured().slope_at_zero();
  EXPECT_EQ(heard.outcome.status, model::RunStatus::completed);
  ASSERT_EQ(heard.outcome.breaks.size(), 1U);
  const model::YarnBreak& event = heard.outcome.breaks.front();
  EXPECT_EQ(event.element, 4);
  // In a step the grip moves 1e-6 of the length; the wave of the ramp is 2e-4 of the force.
  EXPECT_GE(event.axial_force, 1.5 * (1 - 1e-12));
  EXPECT_LT(event.axial_force, 1.5 * (1 + 2e-4));
  EXPECT_NEAR(event.axial_strain, strain, 2e-4 * strain);
  EXPECT_NEAR(event.strain, strain, 5e-3 * strain);
  EXPECT_NEAR(event.position.y(), 4.5 * (1 + strain), 0.01);
  EXPECT_NE(heard.outcome.reason.find("course 1, wale 1, 4.5 mm along the yarn"), std::string::npos)
      << heard.outcome.reason;
  EXPECT_EQ(heard.rows.back().strain, event.strain);
  EXPECT_EQ(heard.frames.back().history.strain, event.strain);
  EXPECT_EQ(heard.rows.back().break_loss, 0);
  EXPECT_TRUE(heard.frames.back().broken.empty());
}

TEST(Break, GivenALawAndStop_ThenTheElementBreaksWhereTheCurveReachesTheStrength) {
  model::Model model = with_law(pulled_yarn(0.25));
  model.strengths = {{0, 2.0}, {1, 1.9}};
  const Heard heard(model, 50);
  ASSERT_EQ(heard.outcome.breaks.size(), 1U);
  const double strain = measured().strain_at(1.9);
  EXPECT_NEAR(heard.outcome.breaks.front().axial_strain, strain, 1e-3 * strain);
  EXPECT_NEAR(heard.outcome.breaks.front().axial_force, 1.9, 2e-3);
}

TEST(Break, GivenGoOn_ThenBothPiecesSpringApartAndTheEnergiesBalance) {
  const Heard heard(with_weak_place(model::OnBreak::go_on), 100);
  EXPECT_EQ(heard.outcome.status, model::RunStatus::completed) << heard.outcome.reason;
  EXPECT_TRUE(heard.outcome.reason.empty());
  EXPECT_NEAR(heard.rows.back().strain, 0.12, 1e-4);
  ASSERT_EQ(heard.outcome.breaks.size(), 1U);
  const model::Frame& last = heard.frames.back();
  EXPECT_EQ(last.broken, std::vector<int>{4});
  EXPECT_EQ(last.axial_force[4], 0);
  EXPECT_EQ(last.axial_strain[4], 0);
  // The upper piece has gone with its grip, the lower is as long as it was, but for the waves that run in both.
  EXPECT_GT(last.points[5].y() - last.points[4].y(), 1 + 0.8 * 0.12 * kLength);
  // Reference: the energy of one of ten equal springs at 1.5 N.
  const double stored = 0.5 * 1.5 * 1.5 / measured().slope_at_zero();
  EXPECT_NEAR(heard.rows.back().break_loss, stored, 2e-3 * stored);
  EXPECT_LT(heard.largest_imbalance(), 0.01);
}

TEST(Break, GivenAYarnThatIsEquallyStrongEverywhereAndGoOn_ThenItDoesNotFallToPieces) {
  // All ten elements reach their strength within one run of a wave through the yarn. One breaks; a second may when the
  // pieces spring back, as nothing but viscosity damps them.
  model::Model model = pulled_yarn(0.12);
  model.strengths = {{0, 1.5}, {1, 1.5}};
  model.test.on_break = model::OnBreak::go_on;
  const Heard heard(model, 100);
  EXPECT_EQ(heard.outcome.status, model::RunStatus::completed) << heard.outcome.reason;
  EXPECT_GE(heard.outcome.breaks.size(), 1U);
  EXPECT_LE(heard.outcome.breaks.size(), 3U);
  EXPECT_LT(heard.largest_imbalance(), 0.01);
}

TEST(Break, GivenABreakAtTheGrip_ThenTheRunGoesOn) {
  // The element next to the driven node alone is weak: the last piece is one node.
  model::Model model = pulled_yarn(0.1);
  model.element_section[4] = 0;
  model.element_section[9] = model.element_section[10] = 1;
  model.strengths = {{1, 1.0}};
  model.test.on_break = model::OnBreak::go_on;
  const Heard heard(model, 20);
  EXPECT_EQ(heard.outcome.status, model::RunStatus::completed) << heard.outcome.reason;
  ASSERT_EQ(heard.outcome.breaks.size(), 1U);
  EXPECT_EQ(heard.outcome.breaks.front().element, 9);
  EXPECT_NEAR(heard.rows.back().force_top, 0, 1e-9);
}

TEST(Break, GivenAllYarnsBroken_ThenTheForceIsZeroAndTheRunGoesOn) {
  model::Model model = test::yarns_through(
      {test::straight({0, 0, 0}, {0, kLength, 0}, 5), test::straight({5, 0, 0}, {5, kLength, 0}, 5)},
      test::section(20, 6, 0.017, 0.012, 1e-11, 0.12));
  const model::Model pulled = pulled_yarn(0.1);
  model.test = pulled.test;
  model.test.on_break = model::OnBreak::go_on;
  model.contact_stiffness = 16;
  model.node_sets[model::kBottomFeet] = {0, 6};
  model.node_sets[model::kTopHeads] = {5, 11};
  model.strengths = {{0, 1.0}};
  const Heard heard(model, 20);
  EXPECT_EQ(heard.outcome.status, model::RunStatus::completed) << heard.outcome.reason;
  EXPECT_GE(heard.outcome.breaks.size(), 2U);
  EXPECT_LT(std::abs(heard.rows.back().force_top), 0.05);
  EXPECT_LT(heard.largest_imbalance(), 0.01);
}

/// 2 wales x 3 courses of the published monofilament.
model::Model small_fabric(double strength, model::OnBreak on_break, model::Centreline centreline) {
  model::Case input = model::example_case();
  input.fabric.wales = 2;
  input.fabric.courses = 3;
  input.fabric.structure = knit::Structure::tied;
  input.yarn.strength = strength;
  input.contact.centreline = centreline;
  input.test = {.strain = 0.35, .speed = 20, .ramp = 0.05, .on_break = on_break};
  return model::build_model(input);
}

class BreakInFabric : public testing::TestWithParam<model::Centreline> {};

TEST_P(BreakInFabric, GivenGoOn_ThenTheTestReachesItsEndAndTheEnergiesBalance) {
  const Heard heard(small_fabric(0.015, model::OnBreak::go_on, GetParam()), 200, 1e3);
  ASSERT_EQ(heard.outcome.status, model::RunStatus::completed) << heard.outcome.reason;
  ASSERT_FALSE(heard.outcome.breaks.empty());
  EXPECT_EQ(heard.outcome.lost_crossings, 0);
  EXPECT_NEAR(heard.rows.back().strain, 0.35, 1e-4);
  EXPECT_EQ(heard.frames.back().broken.size(), heard.outcome.breaks.size());
  EXPECT_GT(heard.rows.back().break_loss, 0);
  EXPECT_LT(heard.largest_imbalance(), 0.01);
  // After the first break the fabric bears less than before.
  const double broke_at = heard.outcome.breaks.front().strain;
  double before = 0;
  for (const model::HistoryRow& row : heard.rows) {
    if (row.strain <= broke_at) before = std::max(before, row.force_top);
  }
  EXPECT_LT(heard.rows.back().force_top, before);
  for (std::size_t i = 1; i < heard.rows.size(); ++i) {
    EXPECT_GE(heard.rows[i].friction_loss, heard.rows[i - 1].friction_loss - 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Centrelines, BreakInFabric,
                         testing::Values(model::Centreline::smooth, model::Centreline::chords));

}  // namespace
}  // namespace knitmech
