#include "model/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace knitmech::model {

int yarn_of_node(const Model& model, std::size_t node) {
  const auto begins_behind = [](std::size_t sought, const ModelYarn& yarn) {
    return sought < static_cast<std::size_t>(yarn.first_node);
  };
  const auto next = std::upper_bound(model.yarns.begin(), model.yarns.end(), node, begins_behind);
  return static_cast<int>(next - model.yarns.begin()) - 1;
}

std::vector<ModelYarn> pieces_of_yarns(const Model& model, const std::vector<int>& broken) {
  const std::set<int> cuts(broken.begin(), broken.end());
  std::vector<ModelYarn> pieces;
  for (const ModelYarn& yarn : model.yarns) {
    ModelYarn piece{yarn.first_node, 0};
    for (int i = yarn.first_node; i < yarn.first_node + yarn.n_nodes; ++i) {
      ++piece.n_nodes;
      if (!cuts.contains(i)) continue;
      pieces.push_back(piece);
      piece = {i + 1, 0};
    }
    if (piece.n_nodes > 0) pieces.push_back(piece);
  }
  return pieces;
}

std::size_t node_near(const Model& model, int yarn, double arc_length) {
  const ModelYarn& nodes = model.yarns.at(static_cast<std::size_t>(yarn));
  const auto first = model.arc_length.begin() + nodes.first_node;
  const auto last = first + nodes.n_nodes - 1;
  const double place = *first + arc_length;
  const auto behind = std::lower_bound(first, last, place);
  const bool before_is_nearer = behind != first && place - *(behind - 1) < *behind - place;
  return static_cast<std::size_t>((before_is_nearer ? behind - 1 : behind) - model.arc_length.begin());
}

double yarn_length_of(const Model& model) {
  double length = 0;
  for (const ModelYarn& yarn : model.yarns) {
    length += model.arc_length[static_cast<std::size_t>(yarn.first_node + yarn.n_nodes - 1)];
  }
  return length;
}

double height_of(const Model& model) {
  const auto [lowest, highest] = std::minmax_element(model.nodes.begin(), model.nodes.end(),
                                                     [](const auto& a, const auto& b) { return a.y() < b.y(); });
  return highest->y() - lowest->y();
}

std::string side_of(const Model& model, std::size_t node) {
  const auto [left, right] = std::minmax_element(model.nodes.begin(), model.nodes.end(),
                                                 [](const auto& a, const auto& b) { return a.x() < b.x(); });
  return 2 * model.nodes[node].x() <= left->x() + right->x() ? "left" : "right";
}

std::string place_text(const Model& model, std::size_t node) {
  const int course = model.course[node] + 1;
  if (!model.has_stitches) return fmt::format("yarn {}", course);
  if (model.wale[node] == knit::kNoWale) return fmt::format("the turning arc of courses {} and {}", course, course + 1);
  return fmt::format("course {}, wale {}", course, model.wale[node] + 1);
}

std::string element_text(const Model& model, std::size_t element) {
  const std::size_t behind = element + 1;
  // Of the two nodes, the one on the arc, or else the one that no other stitch shares.
  const bool arc_begins = model.wale[element] != knit::kNoWale && model.wale[behind] == knit::kNoWale;
  const bool behind_alone = model.wale[element] != knit::kNoWale && model.wale[behind] > model.wale[element];
  const auto first =
      static_cast<std::size_t>(model.yarns[static_cast<std::size_t>(yarn_of_node(model, element))].first_node);
  const double middle = 0.5 * (model.arc_length[element] + model.arc_length[behind]) - model.arc_length[first];
  return fmt::format("{}, {:.4g} mm along the yarn", place_text(model, arc_begins || behind_alone ? behind : element),
                     middle);
}

}  // namespace knitmech::model
