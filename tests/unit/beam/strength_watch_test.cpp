#include "beam/strength_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../../support/beam_case.h"

namespace knitmech::beam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Four elements of 1 mm along x: 0 and 2 of section 0 (linear, 20 N), 1 of section 1 (a law), 3 of section 2, which
/// has no strength.
model::Model chain() {
  model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {4, 0, 0}, 4)}, test::section(20, 8, 0.02, 0.015, 1e-11));
  model.sections.resize(3, model.sections.front());
  model.element_section = {0, 1, 0, 2, 2};
  model.axial_laws.emplace(1, yarn::AxialLaw({{0, 0}, {0.1, 2}, {0.2, 3}, {0.3, 3.5}}));
  model.strengths = {{0, 2.0}, {1, 3.0}};
  return model;
}

/// Strains of the elements from the first on.
model::State strained(const model::Model& model, const std::vector<double>& strains) {
  model::State state = test::state_of(model);
  for (std::size_t i = 0; i < strains.size(); ++i) state.position.x[i + 1] = state.position.x[i] + 1 + strains[i];
  return state;
}

TEST(StrengthWatch, GivenElementsJustBelowAndJustAboveTheirStrength_ThenTheLatterAreFound) {
  // 2 N at a strain of 0.1 in section 0, 3 N at 0.2 by the law of section 1.
  const model::Model model = chain();
  const StrengthWatch watch(model, make_elements(model, 1, 0));
  EXPECT_THAT(watch.overloaded(strained(model, {0.0999999, 0.1999999, -0.5, 2})), IsEmpty());
  EXPECT_THAT(watch.overloaded(strained(model, {0.1000001, 0.1999999, 0, 2})), ElementsAre(0));
  EXPECT_THAT(watch.overloaded(strained(model, {0.0999999, 0.2000001, 0, 2})), ElementsAre(1));
}

TEST(StrengthWatch, GivenSeveralOverloadedElements_ThenTheMostOverloadedComesFirst) {
  const model::Model model = chain();
  StrengthWatch watch(model, make_elements(model, 1, 0));
  const model::State state = strained(model, {0.12, 0.21, 0.15, 0});
  EXPECT_THAT(watch.overloaded(state), ElementsAre(2, 0, 1));
  watch.remove(0);
  EXPECT_THAT(watch.overloaded(state), ElementsAre(2, 1));
}

TEST(StrengthWatch, GivenTwoYarns_ThenTheGapBetweenThemNeverBreaks) {
  model::Model model =
      test::yarns_through({test::straight({0, 0, 0}, {2, 0, 0}, 2), test::straight({0, 50, 0}, {2, 50, 0}, 2)},
                          test::section(20, 8, 0.02, 0.015, 1e-11));
  model.strengths = {{0, 2.0}};
  EXPECT_THAT(StrengthWatch(model, make_elements(model, 1, 0)).overloaded(test::state_of(model)), IsEmpty());
}

TEST(StrengthWatch, GivenNoStrength_ThenItIsNotNeeded) {
  model::Model model = chain();
  model.strengths.clear();
  const StrengthWatch watch(model, make_elements(model, 1, 0));
  EXPECT_FALSE(watch.is_needed());
  EXPECT_THAT(watch.overloaded(strained(model, {5, 5, 5, 5})), IsEmpty());
}

}  // namespace
}  // namespace knitmech::beam
