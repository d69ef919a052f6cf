#include "results/section_peaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "../model/example_case.h"
#include "model/build_model.h"
#include "results/summary.h"
#include "results/yarn_place.h"
#include "sample_run.h"

namespace knitmech::results {
namespace {

constexpr std::size_t kTorque = 3;

model::Frame frame_with_torques(int index, double strain, std::vector<double> torques) {
  model::Frame frame;
  frame.index = index;
  frame.history.strain = strain;
  frame.torque = std::move(torques);
  return frame;
}

TEST(SectionPeaks, GivenSeveralFrames_ThenTheLargestMagnitudeStaysWithItsSignAndFrame) {
  SectionPeaks peaks;
  update(peaks, frame_with_torques(0, 0.0, {0, 0, 0, 0}));
  EXPECT_FALSE(peaks[kTorque]);
  update(peaks, frame_with_torques(1, 0.1, {1, -3, 3, 0}));
  update(peaks, frame_with_torques(2, 0.2, {2, 2, 3, 0}));
  ASSERT_TRUE(peaks[kTorque]);
  EXPECT_EQ(peaks[kTorque]->value, -3);
  EXPECT_EQ(peaks[kTorque]->element, 1U);
  EXPECT_EQ(peaks[kTorque]->frame, 1);
  EXPECT_EQ(peaks[kTorque]->strain, 0.1);
  EXPECT_FALSE(peaks[0]);
}

TEST(SectionPeaks, GivenAValueThatIsNoNumber_ThenItIsPassedOver) {
  SectionPeaks peaks;
  update(peaks, frame_with_torques(0, 0.1, {std::numeric_limits<double>::quiet_NaN(), 1, 0}));
  ASSERT_TRUE(peaks[kTorque]);
  EXPECT_EQ(peaks[kTorque]->value, 1);
}

TEST(SectionPeaks, GivenAFrame_ThenTheSummaryHasEachValueWithItsPlace) {
  const model::Model model = test::two_yarn_model();
  model::Frame frame = test::awkward_frame(model, 2);
  frame.axial_force = {1, 2, 0, 3, -7, 4, 0};  // largest in the second element of the second yarn
  frame.curvature.assign(7, 0.0);
  SectionPeaks peaks;
  update(peaks, frame);
  const std::string text = finished_summary(model, {}, {}, std::nullopt, peaks, {}, {});
  const nlohmann::json block = nlohmann::json::parse(text).at("largest_in_yarns");
  const nlohmann::json& force = block.at("axial_force_N");
  EXPECT_EQ(force.at("value"), -7);
  EXPECT_EQ(force.at("frame"), 2);
  EXPECT_EQ(force.at("strain"), frame.history.strain);
  EXPECT_EQ(force.at("yarn"), 1);
  EXPECT_EQ(force.at("course"), 2);
  EXPECT_NEAR(force.at("place_mm").get<double>(), 0.45, 1e-12);
  EXPECT_TRUE(block.at("curvature_per_mm").is_null());
  for (const char* key : {"shear_force_N", "bending_moment_Nmm", "torque_Nmm", "axial_strain"}) {
    EXPECT_TRUE(block.at(key).contains("value")) << key;
  }
}

class PlaceOfElement : public testing::Test {
 protected:
  static model::Model fabric() {
    model::Case input = model::example_case();
    input.fabric.wales = 3;
    input.fabric.courses = 2;
    input.fabric.elements_per_erc = 20;
    return model::build_model(input);
  }
  const model::Model model_ = fabric();

  /// The element at a share of the way through a wale of the upper course, 0 and 1 at the feet and 0.5 at the head.
  [[nodiscard]] YarnPlace at(int wale, double share) const {
    const int from_left = static_cast<int>(2 * 20 * (wale + share));
    return place_of_element(model_,
                            static_cast<std::size_t>(model_.yarns[1].first_node) + static_cast<std::size_t>(from_left));
  }
};

TEST_F(PlaceOfElement, GivenAFabric_ThenCoursesAndWalesCountFromOneAndStitchesBeginAtTheirLeftFoot) {
  for (const int wale : {0, 1, 2}) {
    for (const double share : {0.01, 0.5, 0.99}) {
      EXPECT_EQ(at(wale, share).course, 2);
      EXPECT_EQ(at(wale, share).wale, wale + 1);
      EXPECT_EQ(at(wale, share).yarn, 1);
    }
  }
  EXPECT_EQ(place_of_element(model_, 0).course, 1);
  EXPECT_NEAR(at(0, 0.01).arc_length, 0.5 * model_.arc_length[1], 1e-12);
}

TEST_F(PlaceOfElement, GivenAFabric_ThenAStitchIsFootLegHeadLegFoot) {
  std::string parts;
  for (int i = 0; i < 40; ++i) {
    const std::string part = at(1, (i + 0.5) / 40).part;
    if (!parts.ends_with(part)) parts += " " + part;
  }
  EXPECT_EQ(parts, " foot leg head leg foot");
  EXPECT_EQ(at(1, 0.25).part, "leg");
}

TEST_F(PlaceOfElement, GivenTheLengthsOfTheLoop_ThenAsMuchYarnLiesOnTheLegsAsTheirStraightPieceHas) {
  // In plan the leg is sqrt(d^2 - (R1 + R2)^2) long, d the distance of the two arcs' middles; out of plane it rises a
  // little. Elements that are cut by an end of the leg do not count.
  const model::Case input = model::example_case();
  const auto& loop = input.loop;
  const double dx = loop.width / 2 - loop.foot_flat - loop.head_flat;
  const double dy = loop.height - loop.head_radius - loop.foot_radius;
  const double radii = loop.head_radius + loop.foot_radius;
  const double in_plan = std::sqrt(dx * dx + dy * dy - radii * radii);
  double on_leg = 0;
  for (int i = 0; i < 20; ++i) {
    const auto element = static_cast<std::size_t>(i);
    if (place_of_element(model_, element).part == "leg")
      on_leg += model_.arc_length[element + 1] - model_.arc_length[element];
  }
  const double element_length = model_.half_stitch_length / 20;
  EXPECT_GT(on_leg, in_plan - 2 * element_length);
  EXPECT_LT(on_leg, 1.05 * in_plan);
}

TEST(PlaceOfElementWithoutStitches, GivenYarnsOfAFile_ThenItIsTheYarnAndTheLengthAlongItAlone) {
  model::Model model = test::two_yarn_model();
  model.has_stitches = false;
  const YarnPlace place = place_of_element(model, 4);
  EXPECT_EQ(place.yarn, 1);
  EXPECT_EQ(place.course, 0);
  EXPECT_FALSE(place.wale.has_value());
  EXPECT_EQ(place.part, "");
  EXPECT_NEAR(place.arc_length, 0.45, 1e-15);
}

TEST(PlaceOfElementOnArc, GivenJoinedCourses_ThenItIsTheTurningArcOfTheLowerCourseAndOfNoWale) {
  model::Case input = model::example_case();
  input.fabric.structure = knit::Structure::adjusted;
  input.fabric.wales = 2;
  input.fabric.courses = 3;
  const model::Model model = model::build_model(input);
  const auto check = [&](int course, const char* edge) {
    const auto foot = static_cast<std::size_t>(model.node_sets.at(edge)[static_cast<std::size_t>(course)]);
    EXPECT_EQ(place_of_element(model, foot - 1).part, "foot");
    EXPECT_EQ(place_of_element(model, foot - 1).course, course + 1);
    for (const std::size_t element : {foot, foot + 1, foot + 3}) {
      const YarnPlace place = place_of_element(model, element);
      EXPECT_EQ(place.part, "turning arc");
      EXPECT_EQ(place.course, course + 1);
      EXPECT_FALSE(place.wale);
    }
  };
  check(0, model::kRightEdge);
  check(1, model::kLeftEdge);
}

}  // namespace
}  // namespace knitmech::results
