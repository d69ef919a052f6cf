#include "exchange/beam_deck.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>

#include "base/errors.h"
#include "exchange/abaqus_section.h"
#include "exchange/constants.h"

namespace knitmech::exchange {

namespace {

using Eigen::Vector3d;

/// A node of orientation along each axis.
std::array<Vector3d, 3> far_nodes(const model::Model& model) {
  Vector3d low = model.nodes.front(), high = low;
  for (const Vector3d& node : model.nodes) {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
  }
  const double distance = std::max(kOrientationDistance, kOrientationExtents * (high - low).maxCoeff());
  std::array<Vector3d, 3> nodes;
  for (int axis = 0; axis < 3; ++axis) {
    nodes[static_cast<std::size_t>(axis)] = 0.5 * (low + high) + distance * Vector3d::Unit(axis);
  }
  return nodes;
}

}  // namespace

BeamSection beam_section(const yarn::Section& section, double mass_scaling) {
  const AbaqusSection same = abaqus_section(section);
  BeamSection result;
  result.diameter = section.diameter;
  result.area = same.area;
  result.youngs_modulus = same.youngs_modulus;
  result.poissons_ratio = same.circle && same.poissons_ratio > 0 ? same.poissons_ratio : 0;
  const double shear_modulus = result.youngs_modulus / (2 * (1 + result.poissons_ratio));
  result.inertia = section.bending_stiffness / result.youngs_modulus;
  result.torsion_constant = section.torsional_stiffness / shear_modulus;
  result.shear_area = section.shear_stiffness / shear_modulus;
  result.density = same.density * mass_scaling;
  return result;
}

BeamMesh beam_mesh(const model::Model& model) {
  const std::array<Vector3d, 3> far = far_nodes(model);
  BeamMesh mesh;
  std::array<int, 3> number{};  // of the node of orientation along each axis; 0: not used yet
  for (const model::ModelYarn& yarn : model.yarns) {
    for (int i = yarn.first_node; i < yarn.first_node + yarn.n_nodes - 1; ++i) {
      const auto node = static_cast<std::size_t>(i);
      const auto axis = static_cast<std::size_t>(first_axis(model.nodes[node + 1] - model.nodes[node]));
      if (number.at(axis) == 0) {
        mesh.orientation_nodes.push_back(far.at(axis));
        number.at(axis) = model.n_nodes() + static_cast<int>(mesh.orientation_nodes.size());
      }
      mesh.elements.push_back({model.element_section[node] + 1, i + 1, i + 2, number.at(axis)});
    }
  }
  return mesh;
}

std::vector<int> used_parts(const BeamMesh& mesh) {
  std::set<int> parts;
  for (const BeamElement& element : mesh.elements) parts.insert(element.part);
  return {parts.begin(), parts.end()};
}

std::vector<model::PairFriction> used_pair_friction(const model::Model& model, const std::vector<int>& parts) {
  const auto is_used = [&](int section) { return std::ranges::binary_search(parts, section + 1); };
  std::vector<model::PairFriction> pairs = model.pair_friction;
  std::erase_if(pairs, [&](const model::PairFriction& pair) {
    return !is_used(pair.first_section) || !is_used(pair.second_section);
  });
  return pairs;
}

bool have_one_diameter(const model::Model& model, const std::vector<int>& parts) {
  const auto diameter = [&](int part) { return model.sections[static_cast<std::size_t>(part) - 1].diameter; };
  return std::ranges::all_of(parts, [&](int part) { return diameter(part) == diameter(parts.front()); });
}

double shortest_element(const model::Model& model) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const model::ModelYarn& yarn : model.yarns) {
    for (int i = yarn.first_node; i < yarn.first_node + yarn.n_nodes - 1; ++i) {
      const auto node = static_cast<std::size_t>(i);
      shortest = std::min(shortest, (model.nodes[node + 1] - model.nodes[node]).norm());
    }
  }
  return shortest;
}

std::vector<std::pair<double, double>> velocity_curve(const model::TensileTest& test) {
  std::vector<std::pair<double, double>> points;
  if (test.ramp > 0) points.emplace_back(0, 0);
  points.emplace_back(test.ramp, 1);
  points.emplace_back(kCurveAfterTheTest * (test.ramp + test_duration(test)), 1);
  return points;
}

double test_duration(const model::TensileTest& test) {
  return test.time_at(test.strain);
}

std::vector<int> node_numbers(const model::Model& model, const std::string& set) {
  std::vector<int> numbers = model.node_sets.at(set);
  for (int& number : numbers) ++number;
  return numbers;
}

void check_for_elastic_deck(const model::Model& model, std::string_view program) {
  for (const std::string& grip : {model.test.held_set, model.test.driven_set}) {
    const auto set = model.node_sets.find(grip);
    if (set == model.node_sets.end() || set->second.empty()) {
      throw std::invalid_argument(fmt::format("the model has no nodes in its grip {}", grip));
    }
  }
  if (model.axial_laws.empty()) return;
  throw InputError(
      fmt::format("the elastic beam of {} has no measured tensile curve; for this deck give the yarn a Young's modulus "
                  "or EA in place of the curve",
                  program));
}

std::vector<std::string> difference_remarks(const model::Model& model) {
  std::vector<std::string> remarks;
  if (model.centreline == model::Centreline::smooth) {
    remarks.emplace_back(
        "Contact is between straight elements here, and between smooth yarns in KnitMech's own run; to");
    remarks.emplace_back(
        "compare, run KnitMech with contact.centreline = \"chords\" and a number for solver.mass_scaling.");
  }
  for (const auto& [section, strength] : model.strengths) {
    remarks.push_back(
        fmt::format("In KnitMech the yarn of part {} breaks at {:.6g} N; here it does not.", section + 1, strength));
  }
  return remarks;
}

}  // namespace knitmech::exchange
