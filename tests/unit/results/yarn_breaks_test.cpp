#include "results/yarn_breaks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "results/frame_file.h"
#include "results/node_values.h"
#include "results/ravelling.h"
#include "results/summary.h"
#include "sample_run.h"
#include "vtk_xml_reader.h"

namespace knitmech::results {
namespace {

using testing::ElementsAre;

/// Element 4 of the sample model: the second of the upper yarn, from node 4 to node 5, a wale further.
const model::YarnBreak kBreak{.strain = 0.2534,
                              .element = 4,
                              .axial_strain = 0.21,
                              .axial_force = 6.0,
                              .position = Eigen::Vector3d(1.5, 0.25, -0.125)};

model::RunOutcome with_breaks(int n) {
  model::RunOutcome outcome;
  for (int i = 0; i < n; ++i) outcome.breaks.push_back(kBreak);
  return outcome;
}

TEST(YarnBreaks, TheTextNamesTheFirstPlaceAndCountsTheOthers) {
  const model::Model model = test::two_yarn_model();
  EXPECT_EQ(breaks_text(model, with_breaks(0)), "");
  EXPECT_EQ(breaks_text(model, with_breaks(1)),
            "Break: a yarn broke in course 2, wale 2, 0.15 mm along the yarn, at 25.3 % strain, with 6 N and stretched "
            "by 21 %.");
  EXPECT_EQ(
      breaks_text(model, with_breaks(3)),
      "Breaks: yarns broke at 3 places, first in course 2, wale 2, 0.15 mm along the yarn, at 25.3 % strain, with "
      "6 N and stretched by 21 %.");
}

TEST(YarnBreaks, TheSummaryListsThemWithTheirPlaces) {
  const model::RunOutcome outcome = with_breaks(1);
  const nlohmann::json summary = nlohmann::json::parse(
      finished_summary(test::two_yarn_model(), {}, {}, {}, {}, outcome, assess_quality({}, outcome, 0.12)));
  ASSERT_EQ(summary["breaks"].size(), 1U);
  const nlohmann::json& event = summary["breaks"][0];
  EXPECT_EQ(event["strain"], 0.2534);
  EXPECT_EQ(event["axial_force_N"], 6.0);
  EXPECT_EQ(event["axial_strain"], 0.21);
  EXPECT_EQ(event["yarn"], 1);
  EXPECT_EQ(event["course"], 2);
  EXPECT_EQ(event["wale"], 2);
  EXPECT_TRUE(event["part"].is_string());
  EXPECT_EQ(event["position_mm"], nlohmann::json({1.5, 0.25, -0.125}));
}

TEST(YarnBreaks, ABrokenEndThatRavelsIsCalledSo) {
  const model::Model model = test::two_yarn_model();
  model::RunOutcome outcome;
  outcome.ravelled = {{.strain = 0.3,
                       .yarn = 1,
                       .is_last_end = true,
                       .broken_end = 4,
                       .other_yarn = 0,
                       .other_place = 0,
                       .position = Eigen::Vector3d::Zero()}};
  EXPECT_EQ(place_of(model, outcome.ravelled.front()).side, "broken");
  EXPECT_EQ(ravelling_text(model, outcome),
            "Ravelling: one yarn end slipped out of a loop, a broken end of course 2 over course 1, wale 1, at 30 % "
            "strain.");
}

TEST(YarnBreaks, AFrameHasALineForEveryPieceOfTwoNodesAndMore) {
  // Yarns of the nodes 0 1 2 and 3 4 5 6; broken between 0 and 1 and between 4 and 5.
  const model::Model model = test::two_yarn_model();
  model::Frame frame = test::awkward_frame(model, 1);
  frame.tie_force.assign(7, Eigen::Vector3d::Zero());
  frame.broken = {0, 4};
  const test::VtkFile file = test::read_vtk_xml(frame_text(model, frame));
  EXPECT_THAT(file.arrays.at("Lines/connectivity").values, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(file.arrays.at("Lines/offsets").values, ElementsAre(2, 4, 6));
  EXPECT_THAT(file.arrays.at("CellData/yarn").values, ElementsAre(0, 1, 1));
}

TEST(YarnBreaks, NodesAtABreakGetTheValueOfTheElementThatTheyStillHave) {
  const std::vector<double> values{2, 4, 99, 1, 0, 7, 99};
  EXPECT_THAT(average_to_nodes(test::two_yarn_model(), {4}, values), ElementsAre(2, 3, 4, 1, 1, 7, 7));
}

}  // namespace
}  // namespace knitmech::results
