#include "knit/turning_arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knitmech::knit {
namespace {

using Eigen::Vector2d;

/// A point of the lower half, from the start to the middle of the leg.
ArcPoint point_on_lower_half(const TurningArc& arc, double s) {
  if (s <= arc.flat) return {{s, 0}, {1, 0}};
  const double quarter = std::numbers::pi / 2 * arc.radius;
  if (s <= arc.flat + quarter) {
    const double angle = (s - arc.flat) / arc.radius;
    return {{arc.flat + arc.radius * std::sin(angle), arc.radius * (1 - std::cos(angle))},
            {std::cos(angle), std::sin(angle)}};
  }
  return {{arc.flat + arc.radius, arc.radius + s - arc.flat - quarter}, {0, 1}};
}

}  // namespace

TurningArc make_turning_arc(const FabricLayout& layout) {
  TurningArc arc;
  arc.flat = layout.loop.foot_flat;
  arc.radius = std::min(layout.loop.foot_radius, layout.course_spacing / 2);
  arc.leg = layout.course_spacing - 2 * arc.radius;
  arc.length = 2 * arc.flat + std::numbers::pi * arc.radius + arc.leg;
  return arc;
}

ArcPoint point_on(const TurningArc& arc, double arc_length) {
  if (arc_length <= arc.length / 2) return point_on_lower_half(arc, std::max(arc_length, 0.0));
  const ArcPoint mirror = point_on_lower_half(arc, std::max(arc.length - arc_length, 0.0));
  const double rise = 2 * arc.radius + arc.leg;
  return {{mirror.position.x(), rise - mirror.position.y()}, {-mirror.tangent.x(), mirror.tangent.y()}};
}

int count_arc_elements(const TurningArc& arc, double erc_length, int elements_per_erc) {
  constexpr int kFewest = 4;  // one to each quarter circle, and the leg
  return std::max(kFewest, static_cast<int>(std::lround(arc.length * elements_per_erc / erc_length)));
}

}  // namespace knitmech::knit
