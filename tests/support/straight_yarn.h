#pragma once

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::test {

/// A straight yarn of 1 mm diameter along y from (0, 0, 0) to (0, 20, 0) mm, of 10 elements, and its undeformed frame.
inline model::Model straight_yarn() {
  model::Model model;
  model.sections = {yarn::Section{.diameter = 1.0}};
  model.yarns = {{.first_node = 0, .n_nodes = 11}};
  model.element_section.assign(11, 0);
  model.course.assign(11, 0);
  model.wale.assign(11, 0);
  for (int i = 0; i <= 10; ++i) {
    model.nodes.emplace_back(0, 2.0 * i, 0);
    model.tangents.emplace_back(0, 1, 0);
    model.arc_length.push_back(2.0 * i);
  }
  return model;
}

inline model::Frame undeformed(const model::Model& model) {
  model::Frame frame;
  const std::size_t count = model.nodes.size();
  frame.points = model.nodes;
  frame.rotations.assign(count, Eigen::Vector4d(1, 0, 0, 0));
  frame.contact_force.assign(count, Eigen::Vector3d::Zero());
  frame.gap.assign(count, 1.0);
  for (auto* values :
       {&frame.axial_force, &frame.shear_force, &frame.bending_moment, &frame.torque, &frame.axial_strain,
        &frame.curvature, &frame.stretch_energy, &frame.bending_energy, &frame.twist_energy}) {
    values->assign(count, 0.0);
  }
  return frame;
}

}  // namespace knitmech::test
