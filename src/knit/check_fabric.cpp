#include "knit/check_fabric.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "base/errors.h"
#include "knit/advice.h"
#include "knit/check_loop.h"
#include "knit/clearance.h"
#include "knit/constants.h"
#include "knit/erc.h"
#include "knit/interlock.h"
#include "knit/out_of_plane.h"

namespace knitmech::knit {
namespace {

void check_at_least_one(const char* key, int value) {
  if (value < 1) throw InputError(fmt::format("{} is {}, but must be 1 or more.", key, value));
}

/// The yarn as it is checked: the true curve, or the elements that stand for it.
struct View {
  int pieces_per_erc = 0;
  std::string subject;         ///< what overlaps, for the message
  std::string further_advice;  ///< what else helps
};

std::string where(const Approach& approach) {
  return fmt::format("{} and {}, near x = {:.4g}, y = {:.4g}, z = {:.4g} mm", describe(approach.a),
                     describe(approach.b), approach.point.x(), approach.point.y(), approach.point.z());
}

std::string advice_on_courses(const FabricLayout& layout, double diameter) {
  const double least = required_out_of_plane(layout, diameter, 0);
  return fmt::format("make loop.out_of_plane at least {} /mm instead of {:.4g} /mm, or \"auto\"", at_least(least),
                     layout.loop.out_of_plane);
}

std::string advice_on(const Approach& approach, const FabricLayout& layout, double diameter) {
  switch (approach.neighbours) {
    case Neighbours::next_course:
    case Neighbours::further_course:
      return advice_on_courses(layout, diameter);
    case Neighbours::next_wale:
      return "make loop.width larger, or loop.head_radius, loop.head_flat or yarn.diameter smaller";
    case Neighbours::same_loop:
      break;
  }
  return "make loop.width or loop.height larger, or loop.foot_radius, loop.foot_flat or yarn.diameter smaller";
}

void check_gap(const Approach& approach, const View& view, const FabricLayout& layout, double diameter) {
  if (approach.gap >= -kTouchingRounding * diameter) return;
  throw InputError(fmt::format("{} overlap by {:.4g} mm between {}; {}{}.", view.subject, -approach.gap,
                               where(approach), advice_on(approach, layout, diameter), view.further_advice));
}

void check_gaps(const Erc& erc, const View& view, const FabricLayout& layout, double diameter) {
  for (const Approach& approach : closest_approaches(erc, layout, diameter, view.pieces_per_erc)) {
    check_gap(approach, view, layout, diameter);
  }
}

}  // namespace

void check_layout(const FabricLayout& layout) {
  check_at_least_one("fabric.wales", layout.wales);
  check_at_least_one("fabric.courses", layout.courses);
  check_at_least_one("fabric.elements_per_erc", layout.elements_per_erc);
  if (layout.course_spacing > 0 && std::isfinite(layout.course_spacing)) return;
  throw InputError(fmt::format("fabric.course_spacing is {} mm, but must be more than 0 mm.", layout.course_spacing));
}

void check_fabric(const FabricLayout& layout, double diameter) {
  check_layout(layout);
  check_loop(layout.loop, diameter);
  const Erc erc = make_erc(layout.loop);
  check_interlock(erc, layout);
  check_gaps(erc, {kCurvePieces, "The yarns", ""}, layout, diameter);
  check_gaps(
      erc, {layout.elements_per_erc, "The straight elements of the yarns", ", or make fabric.elements_per_erc larger"},
      layout, diameter);
}

}  // namespace knitmech::knit
