#include "knit/interlock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/errors.h"
#include "knit/advice.h"
#include "knit/constants.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector3d;

double plan_cross(const Vector3d& a, const Vector3d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Parameters at which two segments cross in plan; each segment includes its start and excludes its end.
struct SegmentCrossing {
  double on_a = 0;
  double on_b = 0;
};

std::optional<SegmentCrossing> crossing_of(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0,
                                           const Vector3d& b1) {
  const Vector3d along_a = a1 - a0;
  const Vector3d along_b = b1 - b0;
  const double determinant = plan_cross(along_a, along_b);
  if (determinant == 0) return std::nullopt;
  const double on_a = plan_cross(b0 - a0, along_b) / determinant;
  const double on_b = plan_cross(b0 - a0, along_a) / determinant;
  if (on_a < 0 || on_a >= 1 || on_b < 0 || on_b >= 1) return std::nullopt;
  return SegmentCrossing{on_a, on_b};
}

/// The ERC in plan, with z / p = -y^2 as third coordinate.
std::vector<Vector3d> scaled_points(const Erc& erc, int n_pieces) {
  std::vector<Vector3d> points;
  for (const CurvePoint& at : equal_arc_points(erc, n_pieces)) {
    const double y = at.position.y();
    points.emplace_back(at.position.x(), y, -y * y);
  }
  return points;
}

/// Three stitches of the next course, the middle one above the ERC's own.
std::vector<Vector3d> next_course(const std::vector<Vector3d>& erc_points, double width, double rise) {
  std::vector<Vector3d> course;
  const auto add = [&](const Vector3d& point, int wale, int side) {
    course.emplace_back(wale * width + side * point.x(), point.y() + rise, point.z());
  };
  for (const int wale : {-1, 0, 1}) {
    for (std::size_t i = erc_points.size() - 1; i > 0; --i) add(erc_points[i], wale, -1);
    for (std::size_t i = 0; i + 1 < erc_points.size(); ++i) add(erc_points[i], wale, 1);
  }
  add(erc_points.back(), 1, 1);
  return course;
}

double between(double start, double end, double parameter) {
  return start + parameter * (end - start);
}

[[noreturn]] void throw_no_interlock(const Erc& erc, double spacing) {
  const std::optional<double> limit = largest_interlocking_spacing(erc, spacing);
  if (!limit) {
    throw InputError(
        fmt::format("The courses do not interlock as in plain jersey at fabric.course_spacing {:.5g} mm, nor closer "
                    "together; make fabric.course_spacing larger, or loop.head_radius and loop.foot_radius smaller.",
                    spacing));
  }
  throw InputError(fmt::format(
      "The courses do not interlock: at fabric.course_spacing {:.5g} mm the loops of loop.height {:.5g} mm do "
      "not reach through each other; make fabric.course_spacing {} mm or less, or loop.height larger.",
      spacing, erc.shape.height, at_most(*limit)));
}

/// Loops that reach through the course after next as well are no plain jersey, whatever their depth.
void check_further_courses(const Erc& erc, const FabricLayout& layout) {
  if (layout.courses == 2) return;
  const double height = erc.shape.height;
  double distance = 2 * layout.course_spacing;
  if (courses_lie_clear(erc, distance, layout.elements_per_erc)) return;
  while (distance < height && !courses_lie_clear(erc, distance, layout.elements_per_erc)) distance += 0.01 * height;
  throw InputError(
      fmt::format("Every course would interlock with the course after next too: fabric.course_spacing {:.5g} mm is too "
                  "small for loops of loop.height {:.5g} mm; make fabric.course_spacing {} mm or more, or loop.height "
                  "smaller.",
                  layout.course_spacing, height, at_least(distance / 2)));
}

}  // namespace

std::vector<PlanCrossing> plan_crossings(const Erc& erc, double course_spacing, int pieces_per_erc) {
  const std::vector<Vector3d> lower = scaled_points(erc, pieces_per_erc);
  const std::vector<Vector3d> upper = next_course(lower, erc.shape.width, course_spacing);
  const double piece = erc.length / pieces_per_erc;
  const double stitch = 2 * erc.length;
  std::vector<PlanCrossing> crossings;
  for (std::size_t i = 0; i + 1 < lower.size(); ++i) {
    for (std::size_t j = 0; j + 1 < upper.size(); ++j) {
      const auto at = crossing_of(lower[i], lower[i + 1], upper[j], upper[j + 1]);
      if (!at) continue;
      const double lead =
          between(lower[i].z(), lower[i + 1].z(), at->on_a) - between(upper[j].z(), upper[j + 1].z(), at->on_b);
      crossings.push_back(
          {(static_cast<double>(i) + at->on_a) * piece, (static_cast<double>(j) + at->on_b) * piece - stitch, lead});
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const PlanCrossing& a, const PlanCrossing& b) { return a.arc_length < b.arc_length; });
  return crossings;
}

bool courses_interlock(const Erc& erc, double course_spacing, int pieces_per_erc) {
  const std::vector<PlanCrossing> crossings = plan_crossings(erc, course_spacing, pieces_per_erc);
  return crossings.size() == 2 && crossings[0].lead < 0 && crossings[1].lead > 0;
}

bool courses_lie_clear(const Erc& erc, double distance, int elements_per_erc) {
  return plan_crossings(erc, distance, kCrossingPieces).empty() &&
         plan_crossings(erc, distance, elements_per_erc).empty();
}

std::optional<double> largest_interlocking_spacing(const Erc& erc, double below) {
  const double start = std::min(below, erc.shape.height);
  const double step = 0.01 * erc.shape.height;
  for (int i = 1; i * step < start; ++i) {
    const double spacing = start - i * step;
    if (courses_interlock(erc, spacing)) return spacing;
  }
  return std::nullopt;
}

void check_interlock(const Erc& erc, const FabricLayout& layout) {
  if (layout.courses == 1) return;
  const double spacing = layout.course_spacing;
  if (!courses_interlock(erc, spacing)) throw_no_interlock(erc, spacing);
  if (!courses_interlock(erc, spacing, layout.elements_per_erc)) {
    throw InputError(
        fmt::format("The {} straight elements of each half loop are too coarse for courses that interlock; make "
                    "fabric.elements_per_erc larger, 10 or more as a rule.",
                    layout.elements_per_erc));
  }
  check_further_courses(erc, layout);
}

}  // namespace knitmech::knit
