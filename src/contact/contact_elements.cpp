#include "contact/contact_elements.h"

#include <algorithm>
#include <cmath>

#include "contact/constants.h"

namespace knitmech::contact {

namespace {

/// Largest angle between the tangents at both ends of an element [rad].
double largest_turn(const model::Model& model) {
  double largest = 0;
  for (const model::ModelYarn& yarn : model.yarns) {
    for (int i = yarn.first_node; i + 1 < yarn.first_node + yarn.n_nodes; ++i) {
      const auto node = static_cast<std::size_t>(i);
      largest = std::max(largest, std::acos(std::clamp(model.tangents[node].dot(model.tangents[node + 1]), -1.0, 1.0)));
    }
  }
  return largest;
}

int pieces_for(const model::Model& model) {
  if (model.centreline != model::Centreline::smooth) return 1;
  return std::clamp(static_cast<int>(std::ceil(largest_turn(model) / kPieceTurn)), kFewestPieces, kMostPieces);
}

}  // namespace

ContactElements make_contact_elements(const model::Model& model) {
  ContactElements elements;
  const auto m = static_cast<std::size_t>(pieces_for(model));
  const std::size_t n = m * (model.nodes.size() - 1) + 1;
  elements.pieces_per_element = static_cast<int>(m);
  elements.yarn.assign(n, 0);
  elements.exists.assign(n, 0);
  elements.radius.assign(model.nodes.size(), 0.0);
  elements.arc_length.assign(n, 0.0);
  for (std::size_t y = 0; y < model.yarns.size(); ++y) {
    const model::ModelYarn& yarn = model.yarns[y];
    const auto first = static_cast<std::size_t>(yarn.first_node);
    const auto last = first + static_cast<std::size_t>(yarn.n_nodes) - 1;
    for (std::size_t p = m * first; p <= m * last; ++p) {
      const std::size_t i = std::min(p / m, last);
      const bool is_last = p == m * last;
      const double length = is_last ? 0 : (model.arc_length[i + 1] - model.arc_length[i]) / static_cast<double>(m);
      const double radius = 0.5 * model.section_of(i).diameter;
      elements.largest_radius = std::max(elements.largest_radius, radius);
      elements.yarn[p] = static_cast<std::int32_t>(y);
      elements.radius[i] = radius;
      elements.exists[p] = is_last ? 0 : 1;
      elements.arc_length[p] = model.arc_length[i] + static_cast<double>(p % m) * length;
    }
  }
  return elements;
}

}  // namespace knitmech::contact
