#include "model/places.h"

#include <gtest/gtest.h>

#include <cmath>

#include "example_case.h"
#include "model/build_model.h"

namespace knitmech::model {
namespace {

Model model_of(knit::Structure structure) {
  Case input = example_case();
  input.fabric.structure = structure;
  input.fabric.wales = 3;
  input.fabric.courses = 3;
  return build_model(input);
}

/// Plain search.
std::size_t nearest_node(const Model& model, const ModelYarn& yarn, double arc_length) {
  auto best = static_cast<std::size_t>(yarn.first_node);
  for (int i = yarn.first_node; i < yarn.first_node + yarn.n_nodes; ++i) {
    const auto node = static_cast<std::size_t>(i);
    if (std::abs(model.arc_length[node] - arc_length) < std::abs(model.arc_length[best] - arc_length)) best = node;
  }
  return best;
}

TEST(Places, GivenAnyPlaceOnAnyYarn_ThenTheNodeNearItIsThatOfAPlainSearch) {
  for (const knit::Structure structure : {knit::Structure::basic, knit::Structure::adjusted}) {
    const Model model = model_of(structure);
    for (int yarn = 0; yarn < static_cast<int>(model.yarns.size()); ++yarn) {
      const ModelYarn& nodes = model.yarns[static_cast<std::size_t>(yarn)];
      const double length = model.arc_length[static_cast<std::size_t>(nodes.first_node + nodes.n_nodes - 1)];
      for (int i = -10; i <= 1010; ++i) {
        const double place = length * i / 1000.1;  // never amid two nodes
        EXPECT_EQ(node_near(model, yarn, place), nearest_node(model, nodes, place)) << place;
      }
    }
  }
}

TEST(Places, GivenANode_ThenItsSideIsThatOfTheFabricWhicheverWayTheYarnRuns) {
  const Model model = model_of(knit::Structure::adjusted);
  for (std::size_t course = 0; course < 3; ++course) {
    EXPECT_EQ(side_of(model, static_cast<std::size_t>(model.node_sets.at(kLeftEdge)[course])), "left");
    EXPECT_EQ(side_of(model, static_cast<std::size_t>(model.node_sets.at(kRightEdge)[course])), "right");
  }
}

TEST(Places, GivenANodeOfAStitch_ThenItIsNamedByCourseAndWaleFromOne) {
  const Model model = model_of(knit::Structure::adjusted);
  EXPECT_EQ(place_text(model, 0), "course 1, wale 1");
  EXPECT_EQ(place_text(model, 45), "course 1, wale 3");
  // The second course runs from right to left.
  const auto right_end = static_cast<std::size_t>(model.node_sets.at(kRightEdge)[1]);
  EXPECT_EQ(place_text(model, right_end + 1), "course 2, wale 3");
}

TEST(Places, GivenANodeOfATurningArc_ThenItIsNamedByTheCoursesThatTheArcJoins) {
  const Model model = model_of(knit::Structure::adjusted);
  const auto right_end = static_cast<std::size_t>(model.node_sets.at(kRightEdge)[0]);
  const auto left_end = static_cast<std::size_t>(model.node_sets.at(kLeftEdge)[1]);
  EXPECT_EQ(place_text(model, right_end + 1), "the turning arc of courses 1 and 2");
  EXPECT_EQ(place_text(model, left_end + 1), "the turning arc of courses 2 and 3");
}

}  // namespace
}  // namespace knitmech::model
