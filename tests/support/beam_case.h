#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace knitmech::test {

/// A yarn with given stiffnesses [N, N mm^2] and mass per length [t/mm], thin enough not to touch anything.
inline yarn::Section section(double axial, double shear, double bending, double torsion, double mass_per_length,
                             double diameter = 1e-3) {
  return {diameter, axial, shear, bending, torsion, mass_per_length};
}

/// A model of yarns given by their nodes [mm], without grips.
inline model::Model yarns_through(const std::vector<std::vector<Eigen::Vector3d>>& polylines,
                                  const yarn::Section& section) {
  model::Model model;
  model.sections = {section};
  for (const auto& polyline : polylines) {
    model.element_section.resize(model.nodes.size() + polyline.size(), 0);
    model.course.resize(model.nodes.size() + polyline.size(), static_cast<int>(model.yarns.size()));
    model.wale.resize(model.nodes.size() + polyline.size(), 0);
    model.yarns.push_back({model.n_nodes(), static_cast<int>(polyline.size())});
    double arc = 0;
    for (std::size_t i = 0; i < polyline.size(); ++i) {
      if (i > 0) arc += (polyline[i] - polyline[i - 1]).norm();
      const std::size_t before = i == 0 ? 0 : i - 1;
      const std::size_t behind = i + 1 == polyline.size() ? i : i + 1;
      model.nodes.push_back(polyline[i]);
      model.tangents.push_back((polyline[behind] - polyline[before]).normalized());
      model.arc_length.push_back(arc);
    }
  }
  model.half_stitch_length = model.arc_length.back();
  return model;
}

/// n + 1 nodes evenly from start to end.
inline std::vector<Eigen::Vector3d> straight(const Eigen::Vector3d& start, const Eigen::Vector3d& end, int n_elements) {
  std::vector<Eigen::Vector3d> nodes;
  for (int i = 0; i <= n_elements; ++i) {
    nodes.emplace_back(start + (end - start) * (static_cast<double>(i) / n_elements));
  }
  return nodes;
}

/// The state of a model as it was built, at rest.
inline model::State state_of(const model::Model& model) {
  model::State state(model.nodes.size());
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    state.position.set(i, {model.nodes[i].x(), model.nodes[i].y(), model.nodes[i].z()});
  }
  return state;
}

inline void set_rotation(model::State& state, std::size_t node, const Eigen::Quaterniond& rotation) {
  state.rotation.w[node] = rotation.w();
  state.rotation.x[node] = rotation.x();
  state.rotation.y[node] = rotation.y();
  state.rotation.z[node] = rotation.z();
}

inline Eigen::Quaterniond rotation_of(const model::State& state, std::size_t node) {
  return {state.rotation.w[node], state.rotation.x[node], state.rotation.y[node], state.rotation.z[node]};
}

inline Eigen::Quaterniond turn(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation_vector / angle));
}

inline Eigen::Vector3d vector_at(const model::VectorArray& field, std::size_t i) {
  return {field.x[i], field.y[i], field.z[i]};
}

}  // namespace knitmech::test
