#include "knit/out_of_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/errors.h"
#include "knit/advice.h"
#include "knit/check_loop.h"
#include "knit/clearance.h"
#include "knit/constants.h"
#include "knit/erc.h"
#include "knit/interlock.h"

namespace knitmech::knit {
namespace {

double gap_at(const Erc& erc, const FabricLayout& layout, double diameter, int pieces) {
  const auto approach = least_gap(closest_approaches(erc, layout, diameter, pieces, kCourseNeighbours));
  return approach ? approach->gap : std::numeric_limits<double>::infinity();
}

double largest_out_of_plane(const LoopShape& shape) {
  return 4 * kLargestDepth / shape.height;
}

}  // namespace

double estimated_out_of_plane(const FabricLayout& layout, double diameter) {
  return diameter / (layout.course_spacing * (layout.loop.height - layout.course_spacing));
}

double gap_between_courses(const FabricLayout& layout, double diameter, double out_of_plane) {
  LoopShape shape = layout.loop;
  shape.out_of_plane = out_of_plane;
  const Erc erc = make_erc(shape);
  return std::min(gap_at(erc, layout, diameter, kCurvePieces), gap_at(erc, layout, diameter, layout.elements_per_erc));
}

std::optional<double> least_out_of_plane(const FabricLayout& layout, double diameter, double gap) {
  const double largest = largest_out_of_plane(layout.loop);
  double low = 0;
  double high = std::clamp(estimated_out_of_plane(layout, diameter), 1e-6 * largest, largest);
  if (gap_between_courses(layout, diameter, low) >= gap) return low;
  while (gap_between_courses(layout, diameter, high) < gap) {
    if (high >= largest) return std::nullopt;
    low = high;
    high = std::min(2 * high, largest);
  }
  while (high - low > kOutOfPlaneAccuracy * high) {
    const double middle = 0.5 * (low + high);
    (gap_between_courses(layout, diameter, middle) < gap ? low : high) = middle;
  }
  return high;
}

double required_out_of_plane(const FabricLayout& layout, double diameter, double gap) {
  if (const std::optional<double> found = least_out_of_plane(layout, diameter, gap)) return *found;
  const double largest = largest_out_of_plane(layout.loop);
  throw InputError(fmt::format(
      "The courses cannot be kept apart: even with loop.out_of_plane {} /mm, a loop as deep as it is high, the "
      "gap between them is {:.4g} mm where {:.4g} mm is due; bring fabric.course_spacing, now {:.5g} mm, nearer "
      "to half of loop.height, {:.5g} mm, or make yarn.diameter smaller.",
      at_least(largest), gap_between_courses(layout, diameter, largest), gap, layout.course_spacing,
      layout.loop.height / 2));
}

double automatic_out_of_plane(const FabricLayout& layout, double diameter) {
  check_loop(layout.loop, diameter);
  if (layout.courses == 1) return 0;
  check_interlock(make_erc(layout.loop), layout);
  return required_out_of_plane(layout, diameter, kAutomaticGap * diameter);
}

}  // namespace knitmech::knit
