// The model of a fabric with tied or joined edges: yarns, sections, node sets, ties, friction.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <vector>

#include "example_case.h"
#include "knit/fabric.h"
#include "model/build_model.h"
#include "model/facts.h"

namespace knitmech::model {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;

constexpr double kArc = 0.4 + std::numbers::pi + 3;  // [mm], 2 l2 + pi R2 + T - 2 R2 of the example

Case case_of(knit::Structure structure, int wales = 4, int courses = 3) {
  Case input = example_case();
  input.fabric.structure = structure;
  input.fabric.wales = wales;
  input.fabric.courses = courses;
  return input;
}

Model model_of(knit::Structure structure, int wales = 4, int courses = 3) {
  return build_model(case_of(structure, wales, courses));
}

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

/// Where the nodes of a set lie, from left to right.
std::vector<Vector3d> places_of(const Model& model, const char* set) {
  std::vector<Vector3d> places;
  for (const int node : model.node_sets.at(set)) places.push_back(model.nodes[at(node)]);
  std::sort(places.begin(), places.end(), [](const Vector3d& a, const Vector3d& b) { return a.x() < b.x(); });
  return places;
}

TEST(AdjustedModel, GivenEvenAndOddCourses_ThenTheGripsHoldTheSamePlacesAsInABasicFabric) {
  for (const int courses : {2, 3}) {
    const Model adjusted = model_of(knit::Structure::adjusted, 4, courses);
    const Model basic = model_of(knit::Structure::basic, 4, courses);
    for (const char* set : {kBottomFeet, kTopHeads}) {
      EXPECT_EQ(places_of(adjusted, set), places_of(basic, set)) << set;
      EXPECT_TRUE(std::ranges::is_sorted(adjusted.node_sets.at(set))) << set;
    }
  }
}

TEST(AdjustedModel, GivenAnyMesh_ThenTheGripsHoldNoNodeOfATurningArc) {
  for (const int n : {8, 10, 20, 40}) {
    Case input = case_of(knit::Structure::adjusted);
    input.fabric.elements_per_erc = n;
    const Model model = build_model(input);
    for (const char* set : {kBottomFeet, kTopHeads}) {
      for (const int node : model.node_sets.at(set)) EXPECT_NE(model.wale[at(node)], knit::kNoWale) << set;
    }
  }
}

TEST(AdjustedModel, ItsEdgesAreTheEndsOfTheCoursesWhicheverWayTheYarnRuns) {
  const Model model = model_of(knit::Structure::adjusted);
  for (std::size_t course = 0; course < 3; ++course) {
    const auto left = at(model.node_sets.at(kLeftEdge)[course]);
    const auto right = at(model.node_sets.at(kRightEdge)[course]);
    EXPECT_NEAR(model.nodes[left].x(), -1.95, 1e-12);
    EXPECT_NEAR(model.nodes[right].x(), 3.5 * 3.9, 1e-12);
    EXPECT_EQ(model.course[left], static_cast<int>(course));
    EXPECT_EQ(model.course[right], static_cast<int>(course));
  }
}

TEST(AdjustedModel, ItsElementsHaveTheEdgeSectionInTheArcsAndTheYarnsInTheStitches) {
  const Model model = model_of(knit::Structure::adjusted);
  ASSERT_EQ(model.sections.size(), 2U);
  ASSERT_EQ(model.yarns.size(), 1U);
  double in_stitches = 0, in_arcs = 0;
  for (std::size_t i = 0; i + 1 < model.nodes.size(); ++i) {
    const bool on_arc = model.wale[i] == knit::kNoWale || model.wale[i + 1] == knit::kNoWale;
    EXPECT_EQ(model.element_section[i], on_arc ? 1 : 0) << "element " << i;
    (on_arc ? in_arcs : in_stitches) += model.arc_length[i + 1] - model.arc_length[i];
  }
  EXPECT_NEAR(in_arcs, 2 * kArc, 1e-10);
  EXPECT_NEAR(in_stitches, 3 * 4 * 2 * model.half_stitch_length, 1e-10);
}

TEST(AdjustedModel, ItsEdgeYarnIsTheYarnButSoftInBendingAndTorsionByDefault) {
  // Published edge yarn: EI = 5e-6 N mm^2. GJ / EI as in the yarn.
  const Model model = model_of(knit::Structure::adjusted);
  const yarn::Section& yarn = model.sections[0];
  const yarn::Section& edge = model.sections[1];
  EXPECT_EQ(edge.bending_stiffness, 5e-6);
  EXPECT_NEAR(edge.torsional_stiffness / edge.bending_stiffness, yarn.torsional_stiffness / yarn.bending_stiffness,
              1e-12);
  EXPECT_EQ(edge.diameter, yarn.diameter);
  EXPECT_EQ(edge.axial_stiffness, yarn.axial_stiffness);
  EXPECT_NEAR(edge.mass_per_length, yarn.mass_per_length, 1e-12 * yarn.mass_per_length);
}

TEST(AdjustedModel, ItsEdgeYarnTakesWhatTheCaseSays) {
  Case input = case_of(knit::Structure::adjusted);
  input.edge_yarn.diameter = 0.1;
  input.edge_yarn.density = 2e-9;
  input.edge_yarn.axial_stiffness = 7;
  input.edge_yarn.bending_stiffness = 3e-5;
  input.edge_yarn.torsional_stiffness = 2e-5;
  const yarn::Section edge = build_model(input).sections.at(1);
  EXPECT_EQ(edge.diameter, 0.1);
  EXPECT_EQ(edge.axial_stiffness, 7);
  EXPECT_EQ(edge.bending_stiffness, 3e-5);
  EXPECT_EQ(edge.torsional_stiffness, 2e-5);
  EXPECT_NEAR(edge.mass_per_length, 2e-9 * std::numbers::pi * 0.1 * 0.1 / 4, 1e-24);
}

TEST(AdjustedModel, ItsEdgeFrictionHoldsForTheEdgeYarnOnAnyYarn) {
  Case input = case_of(knit::Structure::adjusted);
  EXPECT_TRUE(build_model(input).pair_friction.empty());
  input.contact.edge_friction = 0.3;
  const Model model = build_model(input);
  EXPECT_EQ(model.friction, 0.1);
  std::set<std::pair<int, int>> pairs;
  for (const PairFriction& pair : model.pair_friction) {
    EXPECT_EQ(pair.friction, 0.3);
    pairs.insert(std::minmax(pair.first_section, pair.second_section));
  }
  EXPECT_THAT(pairs, ElementsAre(std::pair(0, 1), std::pair(1, 1)));
}

TEST(AdjustedModel, ItsFactsCountTheYarnOfTheArcs) {
  const Case input = case_of(knit::Structure::adjusted);
  const FabricFacts facts = describe(input, build_model(input));
  EXPECT_EQ(facts.n_turning_arcs, 2);
  EXPECT_EQ(facts.n_ties, 0);
  EXPECT_NEAR(facts.turning_arc_length, kArc, 1e-13);
  EXPECT_NEAR(facts.yarn_length, 3 * 4 * facts.stitch_length + 2 * kArc, 1e-10);
  ASSERT_TRUE(facts.edge_section);
  EXPECT_EQ(facts.edge_section->bending_stiffness, 5e-6);
}

TEST(TiedModel, ItsFactsCountTheTies) {
  const Case input = case_of(knit::Structure::tied);
  const FabricFacts facts = describe(input, build_model(input));
  EXPECT_EQ(facts.n_ties, 16);
  EXPECT_EQ(facts.n_turning_arcs, 0);
  EXPECT_FALSE(facts.edge_section);
  EXPECT_NEAR(facts.yarn_length, 3 * 4 * facts.stitch_length, 1e-10);
}

TEST(TiedModel, ItIsTheBasicFabricWithTies) {
  const Model tied = model_of(knit::Structure::tied);
  const Model basic = model_of(knit::Structure::basic);
  EXPECT_EQ(tied.nodes, basic.nodes);
  EXPECT_EQ(tied.yarns.size(), basic.yarns.size());
  EXPECT_EQ(tied.node_sets, basic.node_sets);
  EXPECT_TRUE(basic.ties.empty());
  EXPECT_EQ(tied.ties.size(), 16U);
}

TEST(TiedModel, GivenFineElements_ThenEachTieJoinsTwoElementsThatCrossInPlan) {
  Case input = case_of(knit::Structure::tied);
  input.fabric.elements_per_erc = 80;
  const Model model = build_model(input);
  for (const Tie& tie : model.ties) {
    const auto point = [&](ElementPlace place) {
      EXPECT_GE(place.share, 0);
      EXPECT_LE(place.share, 1);
      const std::size_t i = at(place.element);
      EXPECT_EQ(model.course[i], model.course[i + 1]);
      return Vector3d((1 - place.share) * model.nodes[i] + place.share * model.nodes[i + 1]);
    };
    // Chords of 0.108 mm leave an arc of R = 1 mm by h^2 / (8 R) = 0.0015 mm.
    EXPECT_LT((point(tie.first) - point(tie.second)).head<2>().norm(), 0.004);
    EXPECT_EQ(model.course[at(tie.second.element)], model.course[at(tie.first.element)] + 1);
  }
}

}  // namespace
}  // namespace knitmech::model
