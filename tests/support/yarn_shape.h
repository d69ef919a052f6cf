#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "beam_case.h"
#include "model/model.h"
#include "model/state.h"

namespace knitmech::test {

/// A point of a curve with its unit tangent.
struct Place {
  Eigen::Vector3d position;  ///< [mm]
  Eigen::Vector3d tangent;
};

/// Nodes along a true curve, with its tangents, arc length and points amid the nodes.
struct YarnShape {
  std::vector<Place> places;
  std::vector<double> arc_length;        ///< [mm], from the first node
  std::vector<Eigen::Vector3d> middles;  ///< [mm], as model::Model has them; empty where the true curve is not known
};

/// n + 1 nodes at equal arc lengths of a curve. \param curve place at an arc length between 0 and `length` [mm]
template <typename Curve>
YarnShape along(const Curve& curve, double length, int n_elements) {
  YarnShape shape;
  for (int i = 0; i <= n_elements; ++i) {
    shape.arc_length.push_back(length * i / n_elements);
    shape.places.push_back(curve(shape.arc_length.back()));
    shape.middles.push_back(curve(length * std::min(i + 0.5, static_cast<double>(n_elements)) / n_elements).position);
  }
  return shape;
}

inline YarnShape straight_shape(const Eigen::Vector3d& start, const Eigen::Vector3d& end, int n_elements) {
  const Eigen::Vector3d tangent = (end - start).normalized();
  return along([&](double s) { return Place{start + s * tangent, tangent}; }, (end - start).norm(), n_elements);
}

/// The helix of a radius about the z axis that starts at (radius, 0, 0) and leans from z by an angle, right-handed.
struct Helix {
  double radius;  ///< [mm]
  double angle;   ///< [rad], between tangent and axis
  [[nodiscard]] Place at(double s) const {
    const double turned = s * std::sin(angle) / radius;
    return {{radius * std::cos(turned), radius * std::sin(turned), s * std::cos(angle)},
            {-std::sin(angle) * std::sin(turned), std::sin(angle) * std::cos(turned), std::cos(angle)}};
  }
};

/// Adds a stress-free yarn to a model. \param section index of its section
inline void add_yarn(model::Model& model, const YarnShape& shape, int section = 0) {
  const std::size_t n_nodes = model.nodes.size() + shape.places.size();
  model.element_section.resize(n_nodes, section);
  model.course.resize(n_nodes, static_cast<int>(model.yarns.size()));
  model.wale.resize(n_nodes, 0);
  model.yarns.push_back({model.n_nodes(), static_cast<int>(shape.places.size())});
  for (const Place& place : shape.places) {
    model.nodes.push_back(place.position);
    model.tangents.push_back(place.tangent);
  }
  model.middles.insert(model.middles.end(), shape.middles.begin(), shape.middles.end());
  model.arc_length.insert(model.arc_length.end(), shape.arc_length.begin(), shape.arc_length.end());
  model.half_stitch_length = model.arc_length.back();
}

/// Moves a yarn from its stress-free shape to another one, without twist: every node turns its stress-free tangent into
/// the new one, the first node the shortest way, the others by parallel transport along the yarn. The yarn is bent and
/// stretched accordingly. \param yarn index   \param places one for each of its nodes
inline void bend_to(const model::Model& model, std::size_t yarn, const std::vector<Place>& places,
                    model::State& state) {
  const auto first = static_cast<std::size_t>(model.yarns[yarn].first_node);
  Eigen::Quaterniond rotation = Eigen::Quaterniond::FromTwoVectors(model.tangents[first], places[0].tangent);
  for (std::size_t i = 0; i < places.size(); ++i) {
    // Transport of the frame along the new shape, after that along the stress-free shape is undone.
    if (i > 0) {
      rotation = Eigen::Quaterniond::FromTwoVectors(places[i - 1].tangent, places[i].tangent) * rotation *
                 Eigen::Quaterniond::FromTwoVectors(model.tangents[first + i], model.tangents[first + i - 1]);
    }
    const Eigen::Vector3d& at = places[i].position;
    state.position.set(first + i, {at.x(), at.y(), at.z()});
    set_rotation(state, first + i, rotation);
  }
}

}  // namespace knitmech::test
