#include "model/build_from_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/errors.h"
#include "file_case.h"
#include "model/build_model.h"
#include "model/facts.h"
#include "model/places.h"

namespace knitmech::model {
namespace {

using Eigen::Vector3d;
using testing::AllOf;
using testing::HasSubstr;

/// The small fabric as a file with 30 points a half stitch.
std::vector<curves::YarnLine> fine_yarns() {
  return yarns_of(build_model(small_case(30)));
}

std::string complaint(const Case& input) {
  try {
    static_cast<void>(build_model(input));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

double largest_distance(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b.at(i)).norm());
  return largest;
}

TEST(ModelFromFile, GivenTheYarnsOfAFabricOfLoops_ThenItIsTheModelOfThatFabric) {
  const Model loops = build_model(small_case());
  const Model model = build_model(case_of_yarns(small_case(), fine_yarns()));
  ASSERT_EQ(model.n_nodes(), loops.n_nodes());
  // Where an arc of 1 mm meets a leg, a spline through points 0.29 mm apart cannot follow the jump of the curvature.
  EXPECT_LT(largest_distance(model.nodes, loops.nodes), 3e-3);
  EXPECT_LT(largest_distance(model.middles, loops.middles), 3e-3);
  EXPECT_LT(largest_distance(model.tangents, loops.tangents), 4e-2);
  EXPECT_NEAR(model.half_stitch_length, loops.half_stitch_length, 1e-4 * loops.half_stitch_length);
  EXPECT_NEAR(model.test.gauge_length, loops.test.gauge_length, 1e-6);
  EXPECT_EQ(model.contact_stiffness, loops.contact_stiffness);
  EXPECT_EQ(model.element_section, loops.element_section);
  EXPECT_EQ(model.node_sets.at(kLeftEdge), loops.node_sets.at(kLeftEdge));
  EXPECT_EQ(model.node_sets.at(kRightEdge), loops.node_sets.at(kRightEdge));
}

TEST(ModelFromFile, GivenAFabricOfLoops_ThenTheGripsHoldTheSameArcs) {
  const Model loops = build_model(small_case());
  const Model model = build_model(case_of_yarns(small_case(), fine_yarns()));
  EXPECT_EQ(model.node_sets.at(kBottomFeet), loops.node_sets.at(kBottomFeet));
  EXPECT_EQ(model.node_sets.at(kTopHeads), loops.node_sets.at(kTopHeads));
}

TEST(ModelFromFile, GivenAGripDepth_ThenTheGripsAreAllNodesThatNearToTheEnds) {
  Case input = case_of_yarns(small_case(), fine_yarns());
  input.fabric.grip_depth = 1.5;
  const Model model = build_model(input);
  for (int i = 0; i < model.n_nodes(); ++i) {
    const double y = model.nodes[static_cast<std::size_t>(i)].y();  // -3.5 mm to 13.5 mm
    const auto holds = [&](const char* set) { return std::ranges::count(model.node_sets.at(set), i) == 1; };
    EXPECT_EQ(holds(kBottomFeet), y <= -2.0 + 1e-9) << y;
    EXPECT_EQ(holds(kTopHeads), y >= 12.0 - 1e-9) << y;
  }
}

TEST(ModelFromFile, GivenNoCourses_ThenNodesKnowTheirYarnOnly) {
  const Model model = build_model(case_of_yarns(small_case(), fine_yarns()));
  EXPECT_FALSE(model.has_stitches);
  EXPECT_EQ(model.course[70], 1);
  EXPECT_EQ(model.wale[70], knit::kNoWale);
  EXPECT_EQ(place_text(model, 70), "yarn 2");
  EXPECT_THAT(element_text(model, 70), HasSubstr("yarn 2, 8.2"));
}

TEST(ModelFromFile, GivenAnElementLength_ThenElementsHaveNearlyIt) {
  Case input = case_of_yarns(small_case(), fine_yarns());
  input.fabric.element_length = 0.31;
  const Model model = build_model(input);
  for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(model.yarns[0].n_nodes); ++i) {
    EXPECT_NEAR(model.arc_length[i + 1] - model.arc_length[i], 0.31, 0.001);
  }
}

TEST(ModelFromFile, GivenAUnit_ThenTheFabricIsThatManyTimesAsLarge) {
  Case input = case_of_yarns(small_case(), fine_yarns(), [](const Vector3d& point) { return Vector3d(100 * point); });
  input.fabric.file_unit = 0.01;
  const Model model = build_model(input);
  EXPECT_LT(largest_distance(model.nodes, build_model(case_of_yarns(small_case(), fine_yarns())).nodes), 1e-12);
}

// Two fabrics are the same, and not mirrored, where a proper rotation takes one to the other. The words with an odd
// order of axes turn the third one round: the model is that of a rotated file.
TEST(ModelFromFile, GivenAxes_ThenTheFileIsTurnedAndNeverMirrored) {
  struct Turn {
    FileAxes axes;
    Vector3d (*to_file)(const Vector3d&);
  };
  const std::vector<Turn> turns = {
      {FileAxes::xyz, [](const Vector3d& p) { return p; }},
      {FileAxes::yzx, [](const Vector3d& p) { return Vector3d(p.z(), p.x(), p.y()); }},
      {FileAxes::zxy, [](const Vector3d& p) { return Vector3d(p.y(), p.z(), p.x()); }},
      {FileAxes::xzy, [](const Vector3d& p) { return Vector3d(p.x(), -p.z(), p.y()); }},
      {FileAxes::yxz, [](const Vector3d& p) { return Vector3d(p.y(), p.x(), -p.z()); }},
      {FileAxes::zyx, [](const Vector3d& p) { return Vector3d(-p.z(), p.y(), p.x()); }},
  };
  const Model straight = build_model(case_of_yarns(small_case(), fine_yarns()));
  for (const Turn& turn : turns) {
    Eigen::Matrix3d to_file;
    to_file << turn.to_file(Vector3d::UnitX()), turn.to_file(Vector3d::UnitY()), turn.to_file(Vector3d::UnitZ());
    EXPECT_EQ(to_file.determinant(), 1);
    Case input = case_of_yarns(small_case(), fine_yarns(), turn.to_file);
    input.fabric.file_axes = turn.axes;
    EXPECT_LT(largest_distance(build_model(input).nodes, straight.nodes), 1e-12);
  }
}

TEST(ModelFromFile, GivenYarnsThatOverlap_ThenTheMessageSaysHowMuchWhereAndWhatHelps) {
  Case input = case_of_yarns(small_case(), fine_yarns());
  input.yarn.diameter = 0.2;
  EXPECT_THAT(complaint(input),
              AllOf(HasSubstr("overlap by 0.0"), HasSubstr("% of yarn.diameter = 0.2 mm"), HasSubstr("yarn 2 at "),
                    HasSubstr("thinner yarn"), HasSubstr("fabric.file_unit")));
}

TEST(ModelFromFile, GivenYarnsThatTouchWithinRounding_ThenTheyAreTaken) {
  Case input = case_of_yarns(small_case(), fine_yarns());
  const Model model = build_model(input);
  const auto nearest = nearest_in(input, model, 1);
  ASSERT_TRUE(nearest.has_value());
  input.yarn.diameter = nearest->distance * 1.004;
  EXPECT_EQ(complaint(input), "");
  input.yarn.diameter = nearest->distance * 1.006;
  EXPECT_THAT(complaint(input), HasSubstr("the yarns overlap by"));
}

TEST(ModelFromFile, GivenAYarnThatCrossesItself_ThenTheOverlapIsSeen) {
  curves::YarnLine knot;
  for (int i = 0; i <= 100; ++i) {
    const double at = 0.08 * i;  // more than a turn of a flat ring
    knot.points.emplace_back(3 * std::cos(at), 3 * std::sin(at) + (i > 80 ? 0.01 * (i - 80) : 0), 0.0005 * i);
  }
  EXPECT_THAT(complaint(case_of_yarns(small_case(), {knot})), HasSubstr("where yarn 1 at"));
}

TEST(ModelFromFile, GivenElementsTooLongForTheBends_ThenTheMessageSaysWhere) {
  Case input = case_of_yarns(small_case(), fine_yarns());
  input.fabric.element_length = 5;
  EXPECT_THAT(complaint(input), AllOf(HasSubstr("fabric.element_length of 5 mm is too long"), HasSubstr("yarn 1")));
}

TEST(ModelFromFile, GivenElementsTooManyForAnyMemory_ThenItIsRefusedBeforeTheyAreMade) {
  Case input = case_of_yarns(small_case(), fine_yarns());
  input.fabric.element_length = 1e-9;
  EXPECT_THAT(complaint(input), AllOf(HasSubstr("fabric.element_length"), HasSubstr("at most 20000000")));
}

TEST(ModelFromFile, GivenAFabricLowerThanItsGrips_ThenTheAxesAreSuggested) {
  Case input = case_of_yarns(small_case(), fine_yarns());
  input.fabric.file_axes = FileAxes::xzy;
  EXPECT_THAT(complaint(input), AllOf(HasSubstr("leaves nothing to stretch"), HasSubstr("fabric.file_axes")));
}

TEST(ModelFromFile, GivenAYarnShorterThanThick_ThenTheUnitIsSuggested) {
  Case input = case_of_yarns(small_case(), fine_yarns());
  input.fabric.file_unit = 1e-3;
  EXPECT_THAT(complaint(input), AllOf(HasSubstr("less than it is thick"), HasSubstr("fabric.file_unit")));
}

TEST(FactsOfAFile, GivenTheSmallFabric_ThenSizeAndLengthsAreThoseOfItsCentrelines) {
  const Case input = case_of_yarns(small_case(), fine_yarns());
  const FabricFacts facts = describe(input, build_model(input));
  ASSERT_TRUE(facts.file.has_value());
  EXPECT_NEAR(facts.height, 17, 1e-6);   // two courses of 5 mm and a loop of 7 mm
  EXPECT_NEAR(facts.width, 11.7, 1e-6);  // three wales of 3.9 mm
  EXPECT_NEAR(facts.file->diameter_in_file, 0.12, 1e-15);
  EXPECT_NEAR(facts.file->grip_depth, facts.file->element_length / 2, 1e-3);
  EXPECT_EQ(facts.file->n_points, 3U * 181);
  ASSERT_TRUE(facts.file->closest.has_value());
  EXPECT_GT(facts.file->closest->distance, 0.12);
  EXPECT_EQ(fabric_text(input), "3 yarns from a file");
}

}  // namespace
}  // namespace knitmech::model
