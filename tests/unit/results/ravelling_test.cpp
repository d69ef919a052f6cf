#include "results/ravelling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "results/summary.h"

namespace knitmech::results {
namespace {

/// Three yarns of 17 nodes, courses 0 to 2, along x; stitches of 4 mm of yarn, a node on every millimetre. The yarn of
/// course 1 runs from right to left.
model::Model three_courses() {
  model::Model model;
  model.title = "three courses";
  model.sections = {yarn::Section{.diameter = 0.12}};
  model.half_stitch_length = 2;
  model.test.gauge_length = 10;
  for (int course = 0; course < 3; ++course) {
    model.yarns.push_back({.first_node = model.n_nodes(), .n_nodes = 17});
    for (int i = 0; i < 17; ++i) {
      const int from_left = course == 1 ? 16 - i : i;
      model.nodes.emplace_back(0.5 * from_left, course, 0);
      model.tangents.emplace_back(course == 1 ? -1 : 1, 0, 0);
      model.arc_length.push_back(i);
      model.element_section.push_back(0);
      model.course.push_back(course);
      model.wale.push_back(std::max(0, (from_left - 1) / 4));
    }
  }
  return model;
}

/// The end of course 3 over course 1, in its second stitch.
const model::Ravelling kEvent{.strain = 0.2534,
                              .yarn = 2,
                              .is_last_end = false,
                              .broken_end = {},
                              .other_yarn = 0,
                              .other_place = 5.5,
                              .position = Eigen::Vector3d(1.5, 0.25, -0.125)};

TEST(Ravelling, CoursesAndWalesCountFromOne) {
  const RavelledPlace place = place_of(three_courses(), kEvent);
  EXPECT_EQ(place.course, 3);
  EXPECT_EQ(place.other_course, 1);
  EXPECT_EQ(place.other_wale, 2);
}

TEST(Ravelling, AWaleIsAStitchOfYarn) {
  const model::Model model = three_courses();
  model::Ravelling event = kEvent;
  for (const auto& [place, wale] : {std::pair{0.0, 1}, {3.4, 1}, {4.6, 2}, {7.4, 2}, {8.6, 3}, {15.4, 4}}) {
    event.other_place = place;
    EXPECT_EQ(place_of(model, event).other_wale, wale) << place << " mm";
  }
}

TEST(Ravelling, LeftAndRightAreThoseOfTheFabricWhicheverWayTheYarnRuns) {
  const model::Model model = three_courses();
  model::Ravelling event = kEvent;
  for (const int yarn : {0, 1, 2}) {
    const bool runs_left = yarn == 1;
    event.yarn = yarn;
    event.other_yarn = yarn == 0 ? 2 : 0;
    event.is_last_end = false;
    EXPECT_EQ(place_of(model, event).side, runs_left ? "right" : "left") << "first end of yarn " << yarn;
    event.is_last_end = true;
    EXPECT_EQ(place_of(model, event).side, runs_left ? "left" : "right") << "last end of yarn " << yarn;
  }
}

TEST(Ravelling, WithoutAnyThereIsNoText) {
  EXPECT_EQ(ravelling_text(three_courses(), {}), "");
}

TEST(Ravelling, TheTextOfOneSaysWhichEndSlippedOutOfWhichLoopAndWhen) {
  model::RunOutcome outcome;
  outcome.ravelled = {kEvent};
  EXPECT_EQ(ravelling_text(three_courses(), outcome),
            "Ravelling: one yarn end slipped out of a loop, the left end of course 3 over course 1, wale 2, at 25.3 % "
            "strain.");
}

TEST(Ravelling, TheTextOfSeveralSaysHowManyAndWhichWasFirst) {
  model::RunOutcome outcome;
  model::Ravelling later = kEvent;
  later.yarn = 0;
  later.other_yarn = 1;
  later.strain = 0.4;
  outcome.ravelled = {kEvent, later, later};
  EXPECT_EQ(ravelling_text(three_courses(), outcome),
            "Ravelling: 3 yarn ends slipped out of loops, first the left end of course 3 over course 1, wale 2, at "
            "25.3 % strain.");
}

TEST(Ravelling, GivenNoStitches_ThenTheTextTellsYarns) {
  model::Model model = three_courses();
  model.has_stitches = false;
  model::RunOutcome outcome;
  outcome.ravelled = {kEvent};
  EXPECT_EQ(ravelling_text(model, outcome),
            "Ravelling: one yarn end slipped out of a loop, the left end of yarn 3 over yarn 1, at 25.3 % strain.");
}

nlohmann::json ravelled_in_summary(const model::RunOutcome& outcome) {
  const std::string text = finished_summary(three_courses(), {}, {}, std::nullopt, {}, outcome, {});
  return nlohmann::json::parse(text).at("ravelled");
}

TEST(Ravelling, TheSummaryListsEveryOneInTheOrderOfTime) {
  model::RunOutcome outcome;
  model::Ravelling later = kEvent;
  later.yarn = 1;
  later.is_last_end = true;
  later.other_place = 0.5;
  later.strain = 0.5;
  outcome.ravelled = {kEvent, later};
  const nlohmann::json expected = nlohmann::json::parse(R"([
    {"strain": 0.2534, "yarn": 2, "course": 3, "end": "left", "over_yarn": 0, "over_course": 1, "over_wale": 2,
     "position_mm": [1.5, 0.25, -0.125]},
    {"strain": 0.5, "yarn": 1, "course": 2, "end": "left", "over_yarn": 0, "over_course": 1, "over_wale": 1,
     "position_mm": [1.5, 0.25, -0.125]}
  ])");
  EXPECT_EQ(ravelled_in_summary(outcome), expected);
}

TEST(Ravelling, TheSummaryOfARunWithoutAnyHasAnEmptyList) {
  EXPECT_EQ(ravelled_in_summary({}), nlohmann::json::array());
}

}  // namespace
}  // namespace knitmech::results
