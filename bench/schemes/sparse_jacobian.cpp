#include "schemes/sparse_jacobian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "schemes/constants.h"
#include "solve/selective_mass.h"

namespace knitmech::bench {

namespace {

/// q <- exp(w) q.
void turn(model::RotationArray& rotation, std::size_t i, Vector3 w) {
  const double angle = length(w);
  const double cosine = std::cos(0.5 * angle);
  const Vector3 s = (angle > 0 ? std::sin(0.5 * angle) / angle : 0.5) * w;
  const double q_w = rotation.w[i];
  const Vector3 q{rotation.x[i], rotation.y[i], rotation.z[i]};
  const Vector3 turned = cosine * q + q_w * s + cross(s, q);
  rotation.w[i] = cosine * q_w - dot(s, q);
  rotation.x[i] = turned.x;
  rotation.y[i] = turned.y;
  rotation.z[i] = turned.z;
}

/// Colours of nodes, so that no two of a colour act on the same node.
std::vector<int> colours_of(const std::vector<std::vector<int>>& coupled) {
  std::vector<int> colours(coupled.size(), -1);
  for (std::size_t node = 0; node < coupled.size(); ++node) {
    std::set<int> taken;
    for (const int row : coupled[node]) {
      for (const int other : coupled[static_cast<std::size_t>(row)]) {
        taken.insert(colours[static_cast<std::size_t>(other)]);
      }
    }
    int colour = 0;
    while (taken.contains(colour)) ++colour;
    colours[node] = colour;
  }
  return colours;
}

/// Nodes of an element; those of its neighbour as well if a place is near it, as a strip reaches there.
std::vector<int> nodes_about(const model::Model& model, contact::YarnPlace place) {
  constexpr double near_end = 0.25;
  const auto first_of_yarn = [&](int node) {
    return std::ranges::any_of(model.yarns, [&](const model::ModelYarn& yarn) { return yarn.first_node == node; });
  };
  std::vector<int> nodes{place.element, place.element + 1};
  if (place.share < near_end && !first_of_yarn(place.element)) nodes.push_back(place.element - 1);
  const bool is_last = place.element + 2 >= model.n_nodes() || first_of_yarn(place.element + 2);
  if (place.share > 1 - near_end && !is_last) nodes.push_back(place.element + 2);
  return nodes;
}

/// Takes what the nodes of some rows have in a column.
void add_column(const Unknowns& unknowns, const std::vector<int>& rows, int column, const Eigen::VectorXd& slopes,
                std::vector<Eigen::Triplet<double>>& entries) {
  for (const int row : rows) {
    for (std::size_t k = 0; k < 6; ++k) {
      const int index = unknowns.of(static_cast<std::size_t>(row), k);
      if (index >= 0) entries.emplace_back(index, column, slopes[index]);
    }
  }
}

}  // namespace

Unknowns::Unknowns(const model::Model& model) : index_(6 * model.nodes.size(), -1) {
  const auto given = solve::GivenMotion::by_grips(model);
  std::vector<char> gripped(model.nodes.size(), 0);
  for (const std::string& grip : {model.test.held_set, model.test.driven_set}) {
    for (const int node : model.node_sets.at(grip)) gripped[static_cast<std::size_t>(node)] = 1;
  }
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    for (std::size_t k = 0; k < 6; ++k) {
      const char held = k == 1 ? given.along[node] : (k < 3 ? given.across[node] : gripped[node]);
      if (held == 0) index_[6 * node + k] = size_++;
    }
  }
}

Eigen::VectorXd Unknowns::gather(const model::NodalLoads& loads) const {
  Eigen::VectorXd values(size_);
  for (std::size_t node = 0; node < n_nodes(); ++node) {
    const Vector3 f = loads.force.at(node);
    const Vector3 m = loads.moment.at(node);
    const std::array<double, 6> all{f.x, f.y, f.z, m.x, m.y, m.z};
    for (std::size_t k = 0; k < 6; ++k) {
      if (of(node, k) >= 0) values[of(node, k)] = all[k];
    }
  }
  return values;
}

void Unknowns::move(const Eigen::VectorXd& by, model::State& state) const {
  for (std::size_t node = 0; node < n_nodes(); ++node) {
    const auto value = [&](std::size_t k) { return of(node, k) >= 0 ? by[of(node, k)] : 0.0; };
    state.position.add(node, {value(0), value(1), value(2)});
    turn(state.rotation, node, {value(3), value(4), value(5)});
  }
}

std::vector<std::vector<int>> coupled_nodes(const model::Model& model,
                                            const std::vector<contact::ContactPoint>& contacts) {
  std::vector<std::set<int>> coupled(model.nodes.size());
  const auto couple = [&](const std::vector<int>& nodes) {
    for (const int node : nodes) coupled[static_cast<std::size_t>(node)].insert(nodes.begin(), nodes.end());
  };
  for (const model::ModelYarn& yarn : model.yarns) {
    for (int k = 0; k + 1 < yarn.n_nodes; ++k) couple({yarn.first_node + k, yarn.first_node + k + 1});
  }
  for (const contact::ContactPoint& contact : contacts) {
    std::vector<int> nodes = nodes_about(model, contact.first);
    const std::vector<int> others = nodes_about(model, contact.second);
    nodes.insert(nodes.end(), others.begin(), others.end());
    couple(nodes);
  }
  std::vector<std::vector<int>> lists;
  lists.reserve(coupled.size());
  for (const std::set<int>& nodes : coupled) lists.emplace_back(nodes.begin(), nodes.end());
  return lists;
}

Eigen::SparseMatrix<double> jacobian(const Unknowns& unknowns, const std::vector<std::vector<int>>& coupled,
                                     const std::function<Eigen::VectorXd(const Eigen::VectorXd& by)>& loads) {
  const std::vector<int> colours = colours_of(coupled);
  const int n_colours = 1 + *std::ranges::max_element(colours);
  const Eigen::VectorXd here = loads(Eigen::VectorXd::Zero(unknowns.size()));
  std::vector<Eigen::Triplet<double>> entries;
  for (int colour = 0; colour < n_colours; ++colour) {
    for (std::size_t k = 0; k < 6; ++k) {
      std::vector<std::size_t> moved;
      Eigen::VectorXd by = Eigen::VectorXd::Zero(unknowns.size());
      for (std::size_t node = 0; node < colours.size(); ++node) {
        if (colours[node] != colour || unknowns.of(node, k) < 0) continue;
        moved.push_back(node);
        by[unknowns.of(node, k)] = kDifference;
      }
      const Eigen::VectorXd slopes = (loads(by) - here) / kDifference;
      for (const std::size_t node : moved) {
        add_column(unknowns, coupled[node], unknowns.of(node, k), slopes, entries);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(unknowns.size(), unknowns.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace knitmech::bench
