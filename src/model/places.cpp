#include "model/places.h"

#include <fmt/format.h>

#include <algorithm>

namespace knitmech::model {

std::size_t node_near(const Model& model, int yarn, double arc_length) {
  const ModelYarn& nodes = model.yarns.at(static_cast<std::size_t>(yarn));
  const auto first = model.arc_length.begin() + nodes.first_node;
  const auto last = first + nodes.n_nodes - 1;
  const double place = *first + arc_length;
  const auto behind = std::lower_bound(first, last, place);
  const bool before_is_nearer = behind != first && place - *(behind - 1) < *behind - place;
  return static_cast<std::size_t>((before_is_nearer ? behind - 1 : behind) - model.arc_length.begin());
}

std::string side_of(const Model& model, std::size_t node) {
  const auto [left, right] = std::minmax_element(model.nodes.begin(), model.nodes.end(),
                                                 [](const auto& a, const auto& b) { return a.x() < b.x(); });
  return 2 * model.nodes[node].x() <= left->x() + right->x() ? "left" : "right";
}

std::string place_text(const Model& model, std::size_t node) {
  const int course = model.course[node] + 1;
  if (model.wale[node] == knit::kNoWale) return fmt::format("the turning arc of courses {} and {}", course, course + 1);
  return fmt::format("course {}, wale {}", course, model.wale[node] + 1);
}

}  // namespace knitmech::model
