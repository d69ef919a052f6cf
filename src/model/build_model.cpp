#include "model/build_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/errors.h"
#include "knit/check_fabric.h"
#include "knit/fabric_builder.h"
#include "knit/out_of_plane.h"
#include "model/constants.h"
#include "yarn/monofilament.h"

namespace knitmech::model {
namespace {

Model model_of_yarns(const knit::Fabric& fabric) {
  Model model;
  for (const knit::YarnCurve& curve : fabric.yarns) {
    model.yarns.push_back({.first_node = model.n_nodes(),
                           .n_nodes = static_cast<int>(curve.points.size()),
                           .section = 0,
                           .course = curve.course});
    model.nodes.insert(model.nodes.end(), curve.points.begin(), curve.points.end());
    model.tangents.insert(model.tangents.end(), curve.tangents.begin(), curve.tangents.end());
    model.middles.insert(model.middles.end(), curve.middles.begin(), curve.middles.end());
    model.arc_length.insert(model.arc_length.end(), curve.arc_length.begin(), curve.arc_length.end());
  }
  return model;
}

std::vector<int> nodes_near(const ModelYarn& yarn, const std::vector<double>& distance, double reach) {
  std::vector<int> nodes;
  for (int i = 0; i < yarn.n_nodes; ++i) {
    if (distance[static_cast<std::size_t>(i)] <= reach) nodes.push_back(yarn.first_node + i);
  }
  return nodes;
}

void add_node_sets(Model& model, const knit::Fabric& fabric) {
  const double reach = (kGripShare + kGripRounding) * fabric.erc_length;
  model.node_sets[kBottomFeet] = nodes_near(model.yarns.front(), fabric.yarns.front().from_foot, reach);
  model.node_sets[kTopHeads] = nodes_near(model.yarns.back(), fabric.yarns.back().from_head, reach);
  std::vector<int>& left = model.node_sets[kLeftEdge];
  std::vector<int>& right = model.node_sets[kRightEdge];
  for (const ModelYarn& yarn : model.yarns) {
    left.push_back(yarn.first_node);
    right.push_back(yarn.first_node + yarn.n_nodes - 1);
  }
}

double height_of(const std::vector<Eigen::Vector3d>& points) {
  const auto [lowest, highest] =
      std::minmax_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
  return highest->y() - lowest->y();
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

yarn::Section section_of(const Case& input) {
  const Case::Yarn& yarn = input.yarn;
  const bool any_stiffness = yarn.axial_stiffness || yarn.bending_stiffness || yarn.torsional_stiffness;
  const bool any_material = yarn.youngs_modulus || yarn.poissons_ratio;
  if (any_stiffness && any_material) {
    throw InputError(
        "The yarn is given twice: keep either yarn.youngs_modulus and yarn.poissons_ratio, or yarn.axial_stiffness, "
        "yarn.bending_stiffness and yarn.torsional_stiffness.");
  }
  if (yarn.axial_stiffness && yarn.bending_stiffness && yarn.torsional_stiffness) {
    return yarn::section_of(yarn::MeasuredYarn{.diameter = yarn.diameter,
                                               .density = yarn.density,
                                               .axial_stiffness = *yarn.axial_stiffness,
                                               .bending_stiffness = *yarn.bending_stiffness,
                                               .torsional_stiffness = *yarn.torsional_stiffness});
  }
  if (yarn.youngs_modulus && yarn.poissons_ratio) {
    return yarn::section_of(yarn::Monofilament{.diameter = yarn.diameter,
                                               .youngs_modulus = *yarn.youngs_modulus,
                                               .poissons_ratio = *yarn.poissons_ratio,
                                               .density = yarn.density});
  }
  throw InputError(
      "The stiffness of the yarn is incomplete: give yarn.youngs_modulus and yarn.poissons_ratio together, or "
      "yarn.axial_stiffness, yarn.bending_stiffness and yarn.torsional_stiffness all three.");
}

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
  const knit::Fabric fabric = build_fabric(input);
  Model model = model_of_yarns(fabric);
  model.title = input.title;
  model.sections = {section};
  add_node_sets(model, fabric);
  model.half_stitch_length = fabric.erc_length;
  model.friction = input.contact.friction;
  model.contact_stiffness =
      input.contact.stiffness.value_or(kContactStiffnessShare * section.axial_stiffness / section.diameter);
  model.centreline = input.contact.centreline;
  model.test.grips = input.test.grips;
  model.test.gauge_length = height_of(model.nodes);
  model.test.strain = input.test.strain;
  model.test.speed = input.test.speed;
  model.test.ramp = input.test.ramp;
  return model;
}

}  // namespace knitmech::model
