#include "model/facts.h"

#include <gtest/gtest.h>

#include <numbers>

#include "example_case.h"
#include "model/build_model.h"

namespace knitmech::model {
namespace {

FabricFacts facts_of(const Case& input) {
  return describe(input, build_model(input));
}

struct Counts {
  int elements_per_erc;
  int elements;
  int nodes;
  int degrees_of_freedom;
};

class StandardMesh : public testing::TestWithParam<Counts> {};
INSTANTIATE_TEST_SUITE_P(OfTheExample, StandardMesh,
                         testing::Values(Counts{10, 2700, 2715, 16290}, Counts{20, 5400, 5415, 32490},
                                         Counts{30, 8100, 8115, 48690}));

TEST_P(StandardMesh, IsCounted) {
  const FabricFacts facts = facts_of(example_case(GetParam().elements_per_erc));
  EXPECT_EQ(facts.n_elements, GetParam().elements);
  EXPECT_EQ(facts.n_nodes, GetParam().nodes);
  EXPECT_EQ(facts.n_degrees_of_freedom, GetParam().degrees_of_freedom);
}

TEST(Facts, LengthsAreThoseOfTheCentreline) {
  const FabricFacts facts = facts_of(example_case());
  EXPECT_NEAR(facts.erc.length, 8.64887592209499603, 2e-14);
  EXPECT_NEAR(facts.stitch_length, 2 * 8.64887592209499603, 4e-14);
  EXPECT_NEAR(facts.yarn_length, 270 * 8.64887592209499603, 1e-10);
}

TEST(Facts, SizeIsThatOfTheFabric) {
  const FabricFacts facts = facts_of(example_case());
  EXPECT_NEAR(facts.width, 9 * 3.9, 1e-12);
  EXPECT_NEAR(facts.height, 77, 1e-12);
  EXPECT_NEAR(facts.thickness, 0.02 * 3.5 * 3.5 + 0.12, 1e-12);
}

TEST(Facts, MassPerAreaIsTheYarnOfOneStitchOverItsArea) {
  // 17.2978 mm of yarn of 1140 kg/m^3 and 0.12 mm on 3.9 mm x 5 mm, about 11.44 g/m^2.
  const double yarn_volume = 2 * 8.64887592209499603 * std::numbers::pi * 0.06 * 0.06;
  const double kilograms_per_square_metre = 1140 * yarn_volume * 1e-9 / (3.9e-3 * 5e-3);
  EXPECT_NEAR(facts_of(example_case()).mass_per_area, 1000 * kilograms_per_square_metre, 1e-9);
}

TEST(Facts, LeastOutOfPlaneLiesBelowTheOneInUse) {
  const FabricFacts given = facts_of(example_case());
  EXPECT_FALSE(given.automatic_out_of_plane);
  EXPECT_EQ(given.out_of_plane, 0.02);
  EXPECT_LT(given.least_out_of_plane, 0.02);

  Case input = example_case();
  input.loop.out_of_plane.reset();
  const FabricFacts automatic = facts_of(input);
  EXPECT_TRUE(automatic.automatic_out_of_plane);
  EXPECT_NEAR(automatic.least_out_of_plane, given.least_out_of_plane, 1e-9);
  EXPECT_GT(automatic.out_of_plane, automatic.least_out_of_plane);
  EXPECT_LT(automatic.out_of_plane, 0.02);
}

TEST(Facts, LeastClearanceIsPositiveOnCurveAndElements) {
  const FabricFacts facts = facts_of(example_case());
  ASSERT_TRUE(facts.closest_on_curve);
  ASSERT_TRUE(facts.closest_on_elements);
  EXPECT_EQ(facts.closest_on_curve->neighbours, knit::Neighbours::next_course);
  EXPECT_GT(facts.closest_on_curve->gap, 0);
  EXPECT_GT(facts.closest_on_elements->gap, 0);
  EXPECT_LT(facts.closest_on_elements->gap, facts.closest_on_curve->gap);
}

TEST(Facts, SectionIsThatOfTheModel) {
  EXPECT_NEAR(facts_of(example_case()).section.bending_stiffness, 0.0173039, 5e-8);
}

}  // namespace
}  // namespace knitmech::model
