#include "model/build_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "base/errors.h"
#include "example_case.h"
#include "knit/out_of_plane.h"

namespace knitmech::model {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string complaint(const Case& input) {
  try {
    (void)build_model(input);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::size_t size_of(const Model& model, const char* set) {
  return model.node_sets.at(set).size();
}

TEST(BuildModel, HasTheCountsOfTheExample) {
  const Model model = build_model(example_case());
  EXPECT_EQ(model.n_elements(), 2700);
  EXPECT_EQ(model.n_nodes(), 2715);
  EXPECT_EQ(model.yarns.size(), 15U);
  EXPECT_EQ(model.tangents.size(), model.nodes.size());
  EXPECT_EQ(model.middles.size(), model.nodes.size());
  EXPECT_EQ(model.arc_length.size(), model.nodes.size());
}

TEST(BuildModel, YarnsAreConsecutiveNodesFromTheLowestCourseUp) {
  const Model model = build_model(example_case());
  for (std::size_t i = 0; i < model.yarns.size(); ++i) {
    const ModelYarn& yarn = model.yarns[i];
    EXPECT_EQ(yarn.first_node, static_cast<int>(i) * 181);
    EXPECT_EQ(yarn.n_nodes, 181);
    const auto first = static_cast<std::size_t>(yarn.first_node);
    EXPECT_EQ(model.course[first], static_cast<int>(i));
    EXPECT_EQ(model.element_section[first], 0);
    EXPECT_EQ(model.arc_length[static_cast<std::size_t>(yarn.first_node)], 0);
    EXPECT_NEAR(model.nodes[static_cast<std::size_t>(yarn.first_node)].y(), -3.5 + 5.0 * static_cast<double>(i), 1e-12);
  }
}

TEST(BuildModel, GripsHoldAMiddleAndOneNodeOnEachSideAtN10) {
  // Given 9 wales, 10 foot middles of which two are yarn ends, and 9 head middles.
  const Model model = build_model(example_case());
  EXPECT_EQ(size_of(model, kBottomFeet), 28U);
  EXPECT_EQ(size_of(model, kTopHeads), 27U);
  const auto& feet = model.node_sets.at(kBottomFeet);
  EXPECT_THAT(std::vector<int>(feet.begin(), feet.begin() + 5), ElementsAre(0, 1, 19, 20, 21));
  const auto& heads = model.node_sets.at(kTopHeads);
  const int first = 14 * 181;
  EXPECT_THAT(std::vector<int>(heads.begin(), heads.begin() + 4),
              ElementsAre(first + 9, first + 10, first + 11, first + 29));
}

class Grip : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Meshes, Grip, testing::Values(10, 20, 30, 40));

TEST_P(Grip, HoldsTheSamePieceOfYarnAtEveryMesh) {
  // Given N a multiple of 10, the outermost held nodes lie one tenth of the ERC from the middle: N / 10 on each side.
  const int n = GetParam();
  const Model model = build_model(example_case(n));
  const int each_side = n / 10;
  EXPECT_EQ(size_of(model, kTopHeads), static_cast<std::size_t>(9 * (2 * each_side + 1)));
  EXPECT_EQ(size_of(model, kBottomFeet), static_cast<std::size_t>(8 * (2 * each_side + 1) + 2 * (each_side + 1)));
}

TEST(BuildModel, CoarseMeshIsHeldAtTheMiddlesAlone) {
  const Model model = build_model(example_case(8));
  EXPECT_EQ(size_of(model, kTopHeads), 9U);
  EXPECT_EQ(size_of(model, kBottomFeet), 10U);
}

TEST(BuildModel, GripNodesAreTheLowestFeetAndTheHighestHeads) {
  const Model model = build_model(example_case(30));
  for (const int node : model.node_sets.at(kBottomFeet)) {
    EXPECT_LT(model.nodes[static_cast<std::size_t>(node)].y(), -3.0);
  }
  for (const int node : model.node_sets.at(kTopHeads)) {
    EXPECT_GT(model.nodes[static_cast<std::size_t>(node)].y(), 14 * 5 + 3.0);
  }
}

TEST(BuildModel, EveryNodeSetIsAscending) {
  const Model model = build_model(example_case());
  EXPECT_EQ(model.node_sets.size(), 4U);
  for (const auto& [name, nodes] : model.node_sets) EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end())) << name;
}

TEST(BuildModel, EdgesAreTheEndsOfTheCourses) {
  const Model model = build_model(example_case());
  ASSERT_EQ(size_of(model, kLeftEdge), 15U);
  ASSERT_EQ(size_of(model, kRightEdge), 15U);
  for (std::size_t course = 0; course < 15; ++course) {
    const int left = model.node_sets.at(kLeftEdge)[course];
    const int right = model.node_sets.at(kRightEdge)[course];
    EXPECT_NEAR(model.nodes[static_cast<std::size_t>(left)].x(), -1.95, 1e-12);
    EXPECT_NEAR(model.nodes[static_cast<std::size_t>(right)].x(), 8.5 * 3.9, 1e-12);
  }
}

TEST(BuildModel, GaugeLengthIsTheHeightOfTheFabric) {
  // (C - 1) T + H = 14 x 5 + 7 mm.
  const Model model = build_model(example_case());
  EXPECT_NEAR(model.test.gauge_length, 77, 1e-12);
  EXPECT_EQ(model.test.strain, 0.22);
  EXPECT_EQ(model.test.speed, 5);
  EXPECT_EQ(model.test.ramp, 0.5);
}

TEST(BuildModel, ContactStiffnessComesFromTheSectionAndNotFromTheMesh) {
  // 0.1 EA / D = 0.1 x 19.2265 / 0.12 N/mm.
  EXPECT_NEAR(build_model(example_case(10)).contact_stiffness, 16.0221, 1e-4);
  EXPECT_EQ(build_model(example_case(10)).contact_stiffness, build_model(example_case(30)).contact_stiffness);
}

TEST(BuildModel, ContactStiffnessOfTheCaseIsTaken) {
  Case input = example_case();
  input.contact.stiffness = 3;
  const Model model = build_model(input);
  EXPECT_EQ(model.contact_stiffness, 3);
  EXPECT_EQ(model.friction, 0.1);
}

TEST(BuildModel, GivenOutOfPlaneIsKept) {
  const Model model = build_model(example_case());
  const double depth = -std::min_element(model.nodes.begin(), model.nodes.end(), [](const auto& a, const auto& b) {
                          return a.z() < b.z();
                        })->z();
  EXPECT_NEAR(depth, 0.02 * 3.5 * 3.5, 1e-12);
}

TEST(BuildModel, AutomaticOutOfPlaneIsThatOfTheFabric) {
  Case input = example_case();
  input.loop.out_of_plane.reset();
  const knit::Fabric fabric = build_fabric(input);
  EXPECT_EQ(fabric.layout.loop.out_of_plane, knit::automatic_out_of_plane(fabric.layout, 0.12));
  EXPECT_GT(fabric.layout.loop.out_of_plane, 0);
  EXPECT_EQ(complaint(input), "");
}

TEST(BuildModel, OverlapIsRefusedWithTheLeastOutOfPlane) {
  Case input = example_case();
  input.loop.out_of_plane = 0.01;
  EXPECT_THAT(complaint(input), AllOf(HasSubstr("overlap"), HasSubstr("loop.out_of_plane at least")));
}

TEST(BuildModel, SectionIsThatOfTheMonofilament) {
  const Model model = build_model(example_case());
  ASSERT_EQ(model.sections.size(), 1U);
  EXPECT_NEAR(model.sections[0].axial_stiffness, 19.2265, 5e-5);
}

TEST(BuildModel, SectionMayBeGivenOutright) {
  Case input = example_case();
  input.yarn.youngs_modulus.reset();
  input.yarn.poissons_ratio.reset();
  input.yarn.axial_stiffness = 3;
  input.yarn.bending_stiffness = 5e-6;
  input.yarn.torsional_stiffness = 4e-6;
  const Model model = build_model(input);
  EXPECT_EQ(model.sections[0].axial_stiffness, 3);
  EXPECT_EQ(model.sections[0].bending_stiffness, 5e-6);
  EXPECT_EQ(model.sections[0].torsional_stiffness, 4e-6);
}

TEST(BuildModel, YarnGivenHalfOrTwiceIsRefused) {
  Case half = example_case();
  half.yarn.poissons_ratio.reset();
  EXPECT_THAT(complaint(half), HasSubstr("yarn.poissons_ratio is missing"));
  Case twice = example_case();
  twice.yarn.axial_stiffness = 3;
  EXPECT_THAT(complaint(twice), HasSubstr("twice"));
}

TEST(BuildModel, ASingleStitchIsAModel) {
  Case input = example_case();
  input.fabric.wales = 1;
  input.fabric.courses = 1;
  const Model model = build_model(input);
  EXPECT_EQ(model.n_nodes(), 21);
  EXPECT_NEAR(model.test.gauge_length, 7, 1e-12);
}

}  // namespace
}  // namespace knitmech::model
