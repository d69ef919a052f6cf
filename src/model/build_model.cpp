#include "model/build_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "knit/check_fabric.h"
#include "knit/fabric_builder.h"
#include "knit/out_of_plane.h"
#include "model/build_from_file.h"
#include "model/constants.h"
#include "model/places.h"
#include "model/sections.h"

namespace knitmech::model {
namespace {

template <class Values, class More>
void append(Values& values, const More& more) {
  values.insert(values.end(), more.begin(), more.end());
}

/// Sections by element: 0 in the stitches, 1 in the turning arcs. The last node repeats the element before it.
std::vector<int> sections_along(const knit::YarnCurve& curve) {
  std::vector<int> sections(curve.turns.begin(), curve.turns.end());
  if (sections.size() > 1) sections.back() = sections[sections.size() - 2];
  return sections;
}

Model nodes_of_yarns(const knit::Fabric& fabric) {
  Model model;
  for (const knit::YarnCurve& curve : fabric.yarns) {
    model.yarns.push_back({.first_node = model.n_nodes(), .n_nodes = static_cast<int>(curve.points.size())});
    append(model.nodes, curve.points);
    append(model.tangents, curve.tangents);
    append(model.middles, curve.middles);
    append(model.arc_length, curve.arc_length);
    append(model.element_section, sections_along(curve));
    append(model.course, curve.course);
    append(model.wale, curve.wale);
  }
  return model;
}

/// The nodes of a course within reach of a loop middle. \param distance of the yarn's nodes from it [mm]
std::vector<int> nodes_near(const Model& model, const knit::CourseNodes& course, const std::vector<double>& distance,
                            double reach) {
  const int first_of_yarn = model.yarns[static_cast<std::size_t>(course.yarn)].first_node;
  std::vector<int> nodes;
  for (int i = course.first_node; i < course.first_node + course.n_nodes; ++i) {
    if (distance[static_cast<std::size_t>(i)] <= reach) nodes.push_back(first_of_yarn + i);
  }
  return nodes;
}

void add_node_sets(Model& model, const knit::Fabric& fabric) {
  const double reach = (kGripShare + kGripRounding) * fabric.erc_length;
  const knit::CourseNodes& bottom = fabric.courses.front();
  const knit::CourseNodes& top = fabric.courses.back();
  const auto yarn_of = [&](const knit::CourseNodes& course) -> const knit::YarnCurve& {
    return fabric.yarns[static_cast<std::size_t>(course.yarn)];
  };
  model.node_sets[kBottomFeet] = nodes_near(model, bottom, yarn_of(bottom).from_foot, reach);
  model.node_sets[kTopHeads] = nodes_near(model, top, yarn_of(top).from_head, reach);
  for (const knit::CourseNodes& course : fabric.courses) {
    const int first = model.yarns[static_cast<std::size_t>(course.yarn)].first_node + course.first_node;
    const int last = first + course.n_nodes - 1;
    model.node_sets[kLeftEdge].push_back(course.runs_left ? last : first);
    model.node_sets[kRightEdge].push_back(course.runs_left ? first : last);
  }
}

ElementPlace place_of(const Model& model, const knit::PlaceOnYarn& place) {
  const ModelYarn& yarn = model.yarns[static_cast<std::size_t>(place.yarn)];
  const auto first = model.arc_length.begin() + yarn.first_node;
  const auto next = std::upper_bound(first + 1, first + yarn.n_nodes - 1, place.arc_length);
  const double start = *(next - 1);
  return {static_cast<int>(next - model.arc_length.begin()) - 1, (place.arc_length - start) / (*next - start)};
}

void add_ties(Model& model, const knit::Fabric& fabric) {
  for (const knit::YarnTie& tie : fabric.ties) {
    model.ties.push_back({place_of(model, tie.lower), place_of(model, tie.upper)});
  }
}

void add_edge_yarn(Model& model, const Case& input) {
  model.sections.push_back(edge_section_of(input));
  if (!input.contact.edge_friction) return;
  model.pair_friction = {{0, 1, *input.contact.edge_friction}, {1, 1, *input.contact.edge_friction}};
}

Model model_of_loops(const Case& input) {
  const knit::Fabric fabric = build_fabric(input);
  Model model = nodes_of_yarns(fabric);
  add_node_sets(model, fabric);
  add_ties(model, fabric);
  model.half_stitch_length = fabric.erc_length;
  return model;
}

/// Out of plane 0 where the case leaves it to the program.
knit::FabricLayout layout_as_given(const Case& input) {
  return {.loop = {.height = input.loop.height,
                   .width = input.loop.width,
                   .head_flat = input.loop.head_flat,
                   .head_radius = input.loop.head_radius,
                   .foot_flat = input.loop.foot_flat,
                   .foot_radius = input.loop.foot_radius,
                   .out_of_plane = input.loop.out_of_plane.value_or(0)},
          .wales = input.fabric.wales,
          .courses = input.fabric.courses,
          .course_spacing = input.fabric.course_spacing,
          .structure = input.fabric.structure,
          .elements_per_erc = input.fabric.elements_per_erc};
}

}  // namespace

knit::FabricLayout resolved_layout(const Case& input) {
  knit::FabricLayout layout = layout_as_given(input);
  if (input.loop.out_of_plane) return layout;
  knit::check_layout(layout);
  layout.loop.out_of_plane = knit::automatic_out_of_plane(layout, input.yarn.diameter);
  return layout;
}

knit::Fabric build_fabric(const Case& input) {
  const knit::FabricLayout layout = resolved_layout(input);
  knit::check_fabric(layout, input.yarn.diameter);
  return knit::build_fabric(layout);
}

Model build_model(const Case& input) {
  const yarn::Section section = section_of(input);
  Model model = input.fabric.yarn_file ? model_from_file(input) : model_of_loops(input);
  model.title = input.title;
  model.sections = {section};
  if (const auto law = axial_law_of(input)) model.axial_laws.emplace(0, *law);
  if (input.yarn.strength) model.strengths.emplace(0, *input.yarn.strength);
  if (input.fabric.structure == knit::Structure::adjusted) add_edge_yarn(model, input);
  model.friction = input.contact.friction;
  model.contact_stiffness =
      input.contact.stiffness.value_or(kContactStiffnessShare * section.axial_stiffness / section.diameter);
  model.centreline = input.contact.centreline;
  model.test.grips = input.test.grips;
  model.test.on_break = input.test.on_break;
  model.test.gauge_length = height_of(model);
  model.test.strain = input.test.strain;
  model.test.speed = input.test.speed;
  model.test.ramp = input.test.ramp;
  return model;
}

}  // namespace knitmech::model
