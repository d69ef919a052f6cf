// The measured curve and the strength of a case in its model, and the words and pieces of yarns that break.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "example_case.h"
#include "model/build_model.h"
#include "model/case_rules.h"
#include "model/places.h"

namespace knitmech::model {
namespace {

using testing::HasSubstr;

Case small_case() {
  Case input = example_case();
  input.fabric.wales = 2;
  input.fabric.courses = 2;
  return input;
}

Case with_curve(std::vector<double> forces) {
  Case input = small_case();
  input.yarn.youngs_modulus.reset();
  input.yarn.curve_strains = {0, 0.05, 0.1, 0.2};
  input.yarn.curve_forces = std::move(forces);
  return input;
}

TEST(BuildModel, GivenACurveAndAStrength_ThenTheYarnHasThemAndTheTestKnowsWhatABreakDoes) {
  Case input = with_curve({0, 0.9, 1.6, 2.6});
  input.yarn.strength = 2.5;
  input.test.on_break = OnBreak::go_on;
  const Model model = build_model(input);
  ASSERT_EQ(model.axial_laws.size(), 1U);
  const yarn::AxialLaw& law = model.axial_laws.at(0);
  EXPECT_NEAR(law.force(0.05), 0.9, 1e-14);
  EXPECT_NEAR(law.force(0.2), 2.6, 1e-14);
  EXPECT_NEAR(model.sections[0].axial_stiffness, law.slope_at_zero(), 1e-12);
  ASSERT_EQ(model.strengths.size(), 1U);
  EXPECT_EQ(model.strengths.at(0), 2.5);
  EXPECT_EQ(model.test.on_break, OnBreak::go_on);
}

TEST(BuildModel, GivenNeither_ThenTheYarnIsLinearAndNeverBreaks) {
  const Model model = build_model(small_case());
  EXPECT_TRUE(model.axial_laws.empty());
  EXPECT_TRUE(model.strengths.empty());
  EXPECT_EQ(model.test.on_break, OnBreak::stop);
}

TEST(CaseRules, GivenAStrengthAboveACurveThatEndsFlat_ThenItIsWrong) {
  Case input = with_curve({0, 0.9, 1.6, 1.6});
  input.yarn.strength = 1.6;
  EXPECT_FALSE(broken_rule(input).has_value());
  input.yarn.strength = 1.7;
  const auto broken = broken_rule(input);
  ASSERT_TRUE(broken.has_value());
  EXPECT_EQ(broken->key, "yarn.strength");
  EXPECT_THAT(broken->complaint, HasSubstr("1.7 N is never reached by yarn.curve_forces, which end flat at 1.6 N"));
  // A curve that still rises at its end goes on with its last slope.
  input.yarn.curve_forces = {0, 0.9, 1.6, 1.65};
  EXPECT_FALSE(broken_rule(input).has_value());
}

TEST(Places, GivenBrokenElements_ThenTheYarnsArePiecesInTheOrderOfTheirNodes) {
  const Model model = build_model(small_case());  // two yarns of 41 nodes
  const std::vector<ModelYarn> pieces = pieces_of_yarns(model, {60, 0, 10});
  const std::vector<std::pair<int, int>> expected = {{0, 1}, {1, 10}, {11, 30}, {41, 20}, {61, 21}};
  ASSERT_EQ(pieces.size(), expected.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_EQ(pieces[i].first_node, expected[i].first) << "piece " << i;
    EXPECT_EQ(pieces[i].n_nodes, expected[i].second) << "piece " << i;
  }
  EXPECT_EQ(pieces_of_yarns(model, {}).size(), 2U);
  EXPECT_EQ(yarn_of_node(model, 40), 0);
  EXPECT_EQ(yarn_of_node(model, 41), 1);
}

TEST(Places, GivenAnElement_ThenItsTextNamesTheStitchAndTheLengthOfYarn) {
  // The yarn runs from the left through 20 elements of each stitch.
  const Model model = build_model(small_case());
  const double element = model.arc_length[1];
  EXPECT_EQ(element_text(model, 0), fmt::format("course 1, wale 1, {:.4g} mm along the yarn", 0.5 * element));
  EXPECT_EQ(element_text(model, 41 + 20), fmt::format("course 2, wale 2, {:.4g} mm along the yarn", 20.5 * element));
  EXPECT_EQ(element_text(model, 41 + 19), fmt::format("course 2, wale 1, {:.4g} mm along the yarn", 19.5 * element));
}

}  // namespace
}  // namespace knitmech::model
