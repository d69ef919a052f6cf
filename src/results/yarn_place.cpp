#include "results/yarn_place.h"

#include <algorithm>
#include <cmath>

#include "results/constants.h"

namespace knitmech::results {
namespace {

/// A stitch by its course and wale, counted from 1, and the arc length [mm] to the middle of its head.
struct Stitch {
  int course, wale;
  double to_head;
};

int yarn_of_element(const model::Model& model, std::size_t element) {
  const auto begins_behind = [](std::size_t node, const model::ModelYarn& yarn) {
    return node < static_cast<std::size_t>(yarn.first_node);
  };
  const auto next = std::upper_bound(model.yarns.begin(), model.yarns.end(), element, begins_behind);
  return static_cast<int>(next - model.yarns.begin()) - 1;
}

/// Stitches follow each other from left to right, each from the middle of one foot to the next, its head half way.
Stitch stitch_at(const model::Model& model, const model::ModelYarn& yarn, double arc_length) {
  const auto first = static_cast<std::size_t>(yarn.first_node);
  const std::size_t last = first + static_cast<std::size_t>(yarn.n_nodes) - 1;
  const bool starts_left = model.nodes[first].x() <= model.nodes[last].x();
  const double from_left = starts_left ? arc_length : model.arc_length[last] - arc_length;
  const double length = 2 * model.half_stitch_length;
  if (length <= 0) return {yarn.course + 1, 1, 0};
  const double wale = std::max(0.0, std::floor(from_left / length));
  return {yarn.course + 1, static_cast<int>(wale) + 1, std::abs(from_left - (wale + 0.5) * length)};
}

bool lies_on_leg(const model::Model& model, std::size_t element) {
  const auto in_plan = [&](std::size_t node) { return model.tangents[node].head<2>().normalized().eval(); };
  const Eigen::Vector2d a = in_plan(element);
  const Eigen::Vector2d b = in_plan(element + 1);
  return (b - a).norm() < kStraightLeg && std::abs(a.y()) > kStraightLeg;
}

}  // namespace

YarnPlace place_of_element(const model::Model& model, std::size_t element) {
  const int yarn = yarn_of_element(model, element);
  const double arc_length = 0.5 * (model.arc_length[element] + model.arc_length[element + 1]);
  const Stitch stitch = stitch_at(model, model.yarns[static_cast<std::size_t>(yarn)], arc_length);
  const char* nearer = stitch.to_head < 0.5 * model.half_stitch_length ? "head" : "foot";
  return {yarn, stitch.course, stitch.wale, lies_on_leg(model, element) ? "leg" : nearer, arc_length};
}

}  // namespace knitmech::results
