#include "compare/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/errors.h"
#include "compare/comparison_table.h"
#include "known_curves.h"

namespace knitmech::compare {
namespace {

using test::measured;
using test::simulated;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

double line(double strain) {
  return 2 * strain;
}

/// A toe, then an ever steeper climb, as a fabric has it.
double climb(double strain) {
  return strain < 0.05 ? 0 : 30 * (strain - 0.05) * (strain - 0.05);
}

TEST(Comparison, GivenAConstantDifference_ThenItIsTheRmsAndThatAtEveryStrain) {
  const Comparison found = compare(simulated(0.3, [](double e) { return line(e) + 0.05; }), measured(0, 0.2, line), {});
  EXPECT_NEAR(found.rms, 0.05, 1e-12);
  EXPECT_NEAR(found.largest_force, 0.4, 1e-12);
  EXPECT_NEAR(found.rms_ratio, 0.125, 1e-12);
  ASSERT_EQ(found.at.size(), 4U);  // the quarters
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found.at[i].strain, 0.05 * static_cast<double>(i + 1), 1e-12);
    EXPECT_NEAR(found.at[i].difference, 0.05, 1e-12);
    EXPECT_NEAR(*found.at[i].ratio, 0.05 / line(found.at[i].strain), 1e-12);
  }
}

TEST(Comparison, GivenADifferenceThatGrowsWithTheStrain_ThenTheRmsIsItsEndOverTheRootOfThree) {
  // Reference: the root of the mean of (c e)^2 from 0 to L is c L / sqrt(3).
  const Comparison found = compare(simulated(0.2, line), measured(0, 0.2, [](double e) { return 1.5 * line(e); }), {});
  EXPECT_NEAR(found.rms, 0.2 / std::sqrt(3.0), 1e-6);
}

TEST(Comparison, GivenCurvesOfDifferentEnds_ThenOnlyWhatBothHaveIsCompared) {
  const Comparison found = compare(simulated(0.15, line), measured(0.05, 0.2, line), {.at = {0.05, 0.1}});
  EXPECT_NEAR(found.strains.front(), 0.05, 1e-15);
  EXPECT_NEAR(found.strains.back(), 0.15, 1e-15);
  EXPECT_NEAR(found.rms, 0, 1e-12);
  EXPECT_NEAR(found.largest_force, 0.3, 1e-12);
  ASSERT_EQ(found.at.size(), 2U);
  EXPECT_NEAR(found.at[1].simulated, 0.2, 1e-12);
  EXPECT_NEAR(found.at[1].lowest, 0.18, 1e-12);
  EXPECT_NEAR(found.at[1].highest, 0.22, 1e-12);
}

TEST(Comparison, GivenAFormula_ThenTheWorkIsItsIntegral) {
  // Reference: 30 (L - 0.05)^3 / 3 of climb(), 0.04 of line(), at L = 0.2.
  const Comparison found = compare(simulated(0.2, climb), measured(0, 0.2, line), {});
  EXPECT_NEAR(found.simulated_work, 10 * std::pow(0.15, 3), 1e-6);
  EXPECT_NEAR(found.measured_work, 0.04, 1e-12);
}

TEST(Comparison, GivenSlack_ThenItIsTakenAwayAsToldOrFound) {
  // Given specimens that are the simulated curve itself, but 3 % later.
  const auto late = [](double e) { return climb(e - 0.03); };
  const SimulatedCurve curve = simulated(0.2, climb);
  const Comparison as_it_is = compare(curve, measured(0, 0.2, late), {});
  EXPECT_EQ(as_it_is.offset, 0);
  EXPECT_GT(as_it_is.rms_ratio, 0.2);
  // When the offset is given, or found.
  const Comparison told = compare(curve, measured(0, 0.2, late), {.offset = 0.03});
  const Comparison found = compare(curve, measured(0, 0.2, late), {.finds_offset = true});
  // Then nothing differs, on the strains of the simulation.
  EXPECT_LT(told.rms_ratio, 1e-5);
  EXPECT_NEAR(told.strains.back(), 0.17, 1e-12);
  EXPECT_NEAR(found.offset, 0.03, 1e-5);
  EXPECT_LT(found.rms_ratio, 1e-4);
  // And so for a simulated curve that is late.
  EXPECT_NEAR(compare(simulated(0.2, late), measured(0, 0.2, climb), {.finds_offset = true}).offset, -0.03, 1e-5);
}

TEST(Comparison, GivenACurveWithinTheSpecimensOnHalfOfTheStrains_ThenThatIsTheShare) {
  const auto half = [](double e) { return e < 0.1 ? 1.05 * line(e) : 1.2 * line(e); };
  const Comparison found = compare(simulated(0.2, half), measured(0, 0.2, line), {});
  ASSERT_TRUE(found.share_in_range);
  EXPECT_NEAR(*found.share_in_range, 0.5, 0.01);
  yarn::MeanCurve alone = measured(0, 0.2, line);
  alone.n_curves = 1;
  EXPECT_FALSE(compare(simulated(0.2, half), alone, {}).share_in_range);
}

TEST(Comparison, GivenNothingToCompare_ThenItSaysWhatTheCurvesHave) {
  const auto comparing = [](double end, double from, double to, const ComparisonSettings& settings) {
    return [=] { static_cast<void>(compare(simulated(end, line), measured(from, to, line), settings)); };
  };
  EXPECT_THAT(comparing(0.1, 0.12, 0.2, {}),
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("no strains in common"), HasSubstr("0 % to 10 %"), HasSubstr("12 % to 20 %"))));
  EXPECT_THAT(comparing(0.1, 0, 0.2, {.at = {0.05, 0.15}}),
              ThrowsMessage<InputError>(AllOf(HasSubstr("0.15"), HasSubstr("0 % to 10 %"))));
  EXPECT_THAT(
      [] { static_cast<void>(compare(simulated(0.1, line), measured(0, 0.2, [](double) { return 0.0; }), {})); },
      ThrowsMessage<InputError>(HasSubstr("no measured force is above 0")));
}

TEST(ComparisonTable, GivenAComparison_ThenEveryGridStrainIsALineThatReadsBackToTheSameBits) {
  const Comparison found = compare(simulated(0.2, climb), measured(0, 0.2, line), {});
  std::istringstream table(comparison_table(found));
  std::string text;
  std::getline(table, text);
  EXPECT_EQ(text, kComparisonHeader);
  for (std::size_t i = 0; i < found.strains.size(); ++i) {
    ASSERT_TRUE(std::getline(table, text));
    std::ranges::replace(text, ',', ' ');
    std::istringstream numbers(text);
    for (const auto* values : {&found.strains, &found.simulated, &found.mean, &found.lowest, &found.highest}) {
      double number = 0;
      numbers >> number;
      EXPECT_EQ(number, (*values)[i]);
    }
  }
  EXPECT_FALSE(std::getline(table, text));
}

}  // namespace
}  // namespace knitmech::compare
