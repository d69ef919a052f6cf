#include "results/yarn_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/places.h"
#include "results/constants.h"

namespace knitmech::results {
namespace {

/// Half way between the feet and the heads of a course before the test [mm].
double mid_height(const model::Model& model, int course) {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (model.course[i] != course || model.wale[i] == knit::kNoWale) continue;
    low = std::min(low, model.nodes[i].y());
    high = std::max(high, model.nodes[i].y());
  }
  return 0.5 * (low + high);
}

bool lies_on_leg(const model::Model& model, std::size_t element) {
  const auto in_plan = [&](std::size_t node) { return model.tangents[node].head<2>().normalized().eval(); };
  const Eigen::Vector2d a = in_plan(element);
  const Eigen::Vector2d b = in_plan(element + 1);
  return (b - a).norm() < kStraightLeg && std::abs(a.y()) > kStraightLeg;
}

}  // namespace

YarnPlace place_of_element(const model::Model& model, std::size_t element) {
  const int yarn = model::yarn_of_node(model, element);
  const double arc_length = 0.5 * (model.arc_length[element] + model.arc_length[element + 1]);
  if (!model.has_stitches) return {yarn, 0, std::nullopt, "", arc_length};
  const std::size_t behind = element + 1;
  const bool on_arc = model.wale[element] == knit::kNoWale || model.wale[behind] == knit::kNoWale;
  const int course = model.course[element];
  if (on_arc) return {yarn, course + 1, std::nullopt, "turning arc", arc_length};
  const double height = 0.5 * (model.nodes[element].y() + model.nodes[behind].y());
  const char* const end = height > mid_height(model, course) ? "head" : "foot";
  // Of the two nodes, the one that no other stitch shares.
  const int wale = std::max(model.wale[element], model.wale[behind]);
  return {yarn, course + 1, wale + 1, lies_on_leg(model, element) ? "leg" : end, arc_length};
}

}  // namespace knitmech::results
