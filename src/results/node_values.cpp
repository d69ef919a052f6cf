#include "results/node_values.h"

#include <algorithm>

#include "model/places.h"

namespace knitmech::results {

std::vector<double> average_to_nodes(const model::Model& model, const std::vector<double>& element_values) {
  return average_to_nodes(model, {}, element_values);
}

std::vector<double> average_to_nodes(const model::Model& model, const std::vector<int>& broken,
                                     const std::vector<double>& element_values) {
  std::vector<double> values(model.nodes.size(), 0.0);
  for (const model::ModelYarn& yarn : model::pieces_of_yarns(model, broken)) {
    const auto first = static_cast<std::size_t>(yarn.first_node);
    const std::size_t end = first + static_cast<std::size_t>(yarn.n_nodes);
    for (std::size_t node = first; node < end && yarn.n_nodes > 1; ++node) {
      const double before = node > first ? element_values[node - 1] : element_values[node];
      const double after = node + 1 < end ? element_values[node] : before;
      values[node] = 0.5 * (before + after);
    }
  }
  return values;
}

std::vector<double> elements_only(const model::Model& model, const std::vector<double>& element_values) {
  std::vector<double> values;
  values.reserve(element_values.size());
  for (const model::ModelYarn& yarn : model.yarns) {
    const auto first = element_values.begin() + yarn.first_node;
    values.insert(values.end(), first, first + std::max(0, yarn.n_nodes - 1));
  }
  return values;
}

}  // namespace knitmech::results
