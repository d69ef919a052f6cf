#include "knit/check_loop.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "knit/advice.h"
#include "knit/constants.h"
#include "knit/erc.h"

namespace knitmech::knit {
namespace {

void check_positive(const char* key, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw InputError(fmt::format("{} is {} mm, but must be more than 0 mm.", key, value));
}

void check_not_negative(const char* key, double value, const char* unit) {
  if (value >= 0 && std::isfinite(value)) return;
  throw InputError(fmt::format("{} is {} {}, but must be 0 or more.", key, value, unit));
}

void check_flat_fits(const char* key, double flat, double width) {
  if (2 * flat < width) return;
  throw InputError(fmt::format(
      "{} is half the length of its flat and must be less than half of loop.width, {:.5g} mm, but is {:.5g} mm.", key,
      width / 2, flat));
}

/// |C2 - C1| > R1 + R2, solved for H and for R1 + R2 to give the advice.
void check_room_for_leg(const LoopShape& shape) {
  const double radii = shape.head_radius + shape.foot_radius;
  const Eigen::Vector2d between = foot_circle_middle(shape) - head_circle_middle(shape);
  const double distance = between.norm();
  if (distance > radii) return;
  const double across = between.x();
  const double least_height = radii + std::sqrt(radii * radii - across * across);
  const double largest_radii = (shape.height * shape.height + across * across) / (2 * shape.height);
  throw InputError(fmt::format(
      "The head and the foot circle leave no room for a leg: their middles are {:.4g} mm apart, but "
      "loop.head_radius + loop.foot_radius is {:.4g} mm, {:.4g} mm too much; make loop.height more than {} mm, "
      "or the sum of the two radii less than {} mm.",
      distance, radii, radii - distance, at_least(least_height), at_most(largest_radii)));
}

void check_leg_runs_down(const LoopShape& shape) {
  const Eigen::Vector2d touch = leg_touch_direction(shape);
  const double sweep = std::numbers::pi / 2 - std::atan2(touch.y(), touch.x());
  if (sweep > 0 && sweep < std::numbers::pi) return;
  throw InputError(fmt::format(
      "The leg of the loop does not run down from the head to the foot: the flats of {:.4g} mm and {:.4g} mm "
      "and the radii of {:.4g} mm and {:.4g} mm do not fit into the loop; raise loop.height or loop.width, or "
      "make loop.head_flat or loop.foot_flat smaller.",
      shape.head_flat, shape.foot_flat, shape.head_radius, shape.foot_radius));
}

struct LoopEnd {
  const char* flat_key;
  const char* radius_key;
  const char* plural;
  double flat;
  double radius;
};

void check_bend(const LoopEnd& end, double diameter) {
  if (2 * end.radius >= diameter) return;
  throw InputError(fmt::format(
      "{} is {:.4g} mm, but yarn of yarn.diameter {:.4g} mm cannot be bent tighter than its own radius; make {} "
      "at least {} mm or the yarn thinner.",
      end.radius_key, end.radius, diameter, end.radius_key, at_least(diameter / 2)));
}

void check_width(const LoopEnd& end, double width, double diameter) {
  const double needed = 2 * (end.flat + end.radius) + diameter;
  if (needed <= width + kTouchingRounding * diameter) return;
  throw InputError(
      fmt::format("The {} of neighbouring wales overlap by {:.4g} mm: 2 ({} + {}) + yarn.diameter is {:.4g} mm, but "
                  "loop.width is {:.4g} mm; make loop.width at least {} mm, or {} + {} at most {} mm.",
                  end.plural, needed - width, end.flat_key, end.radius_key, needed, width, at_least(needed),
                  end.flat_key, end.radius_key, at_most((width - diameter) / 2)));
}

}  // namespace

void check_loop_shape(const LoopShape& shape) {
  check_positive("loop.height", shape.height);
  check_positive("loop.width", shape.width);
  check_positive("loop.head_radius", shape.head_radius);
  check_positive("loop.foot_radius", shape.foot_radius);
  check_not_negative("loop.head_flat", shape.head_flat, "mm");
  check_not_negative("loop.foot_flat", shape.foot_flat, "mm");
  check_not_negative("loop.out_of_plane", shape.out_of_plane, "/mm");
  check_flat_fits("loop.head_flat", shape.head_flat, shape.width);
  check_flat_fits("loop.foot_flat", shape.foot_flat, shape.width);
  check_room_for_leg(shape);
  check_leg_runs_down(shape);
}

void check_loop(const LoopShape& shape, double diameter) {
  check_loop_shape(shape);
  check_positive("yarn.diameter", diameter);
  const LoopEnd head = {"loop.head_flat", "loop.head_radius", "heads", shape.head_flat, shape.head_radius};
  const LoopEnd foot = {"loop.foot_flat", "loop.foot_radius", "feet", shape.foot_flat, shape.foot_radius};
  for (const LoopEnd& end : {head, foot}) check_bend(end, diameter);
  const bool leans_back = leg_touch_direction(shape).y() < 0;
  if (!leans_back) return;
  for (const LoopEnd& end : {head, foot}) check_width(end, shape.width, diameter);
}

}  // namespace knitmech::knit
