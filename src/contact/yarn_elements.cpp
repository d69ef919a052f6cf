#include "contact/yarn_elements.h"

#include <algorithm>
#include <limits>

namespace knitmech::contact {

YarnElements make_yarn_elements(const model::Model& model) {
  const std::size_t n = model.nodes.size();
  YarnElements elements;
  elements.yarn.assign(n, 0);
  elements.section.assign(n, 0);
  elements.exists.assign(n, 0);
  elements.radius.assign(n, 0.0);
  elements.length.assign(n, 0.0);
  elements.before.assign(n, 0.0);
  elements.after.assign(n, 0.0);
  for (std::size_t y = 0; y < model.yarns.size(); ++y) {
    const model::ModelYarn& yarn = model.yarns[y];
    const auto first = static_cast<std::size_t>(yarn.first_node);
    const auto last = first + static_cast<std::size_t>(yarn.n_nodes) - 1;
    for (std::size_t i = first; i <= last; ++i) {
      elements.yarn[i] = static_cast<std::int32_t>(y);
      elements.section[i] = model.element_section[i];
      elements.radius[i] = 0.5 * model.section_of(i).diameter;
      elements.exists[i] = i < last ? 1 : 0;
      elements.length[i] = i < last ? model.arc_length[i + 1] - model.arc_length[i] : 0;
      elements.before[i] = model.arc_length[i] - model.arc_length[first];
      elements.after[i] = model.arc_length[last] - model.arc_length[i];
    }
  }
  elements.shortest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < n; ++i) {
    if (elements.exists[i] != 0) elements.shortest = std::min(elements.shortest, elements.length[i]);
  }
  return elements;
}

}  // namespace knitmech::contact
