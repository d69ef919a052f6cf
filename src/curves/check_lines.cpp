#include "curves/check_lines.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"
#include "curves/constants.h"

namespace knitmech::curves {
namespace {

/// Also false for what is no number.
bool is_usual(double value) {
  return std::abs(value) <= kLargestCoordinate;
}

void check_points(const YarnLine& yarn, std::size_t index, std::size_t least) {
  if (yarn.points.size() < least) {
    throw InputError(fmt::format("{} has {} point{}, but needs at least {}", yarn_text(index), yarn.points.size(),
                                 yarn.points.size() == 1 ? "" : "s", least));
  }
  for (std::size_t i = 0; i < yarn.points.size(); ++i) {
    const Eigen::Vector3d& point = yarn.points[i];
    if (is_usual(point.x()) && is_usual(point.y()) && is_usual(point.z())) continue;
    throw InputError(fmt::format("{}, point {}: ({:g}, {:g}, {:g}) is no place; coordinates are numbers up to {:g}",
                                 yarn_text(index), i + 1, point.x(), point.y(), point.z(), kLargestCoordinate));
  }
  if (!is_usual(yarn.radius) || yarn.radius < 0) {
    throw InputError(fmt::format("{} has a radius of {:g}, which is none", yarn_text(index), yarn.radius));
  }
}

}  // namespace

std::string yarn_text(std::size_t index) {
  return fmt::format("yarn {}", index + 1);
}

void close_where_ends_meet(YarnLine& yarn) {
  constexpr std::size_t kLeast = 4;  // a triangle, and its first corner once more
  if (yarn.points.size() < kLeast || yarn.points.front() != yarn.points.back()) return;
  yarn.points.pop_back();
  yarn.closed = true;
}

void check_lines(const YarnLines& lines) {
  if (lines.yarns.empty()) throw InputError("has no yarn");
  if (lines.yarns.size() > kMostYarns) {
    throw InputError(fmt::format("has {} yarns; at most {} are possible", lines.yarns.size(), kMostYarns));
  }
  const std::size_t outer = lines.kind == LineKind::inner_points ? 2 : 0;
  for (std::size_t i = 0; i < lines.yarns.size(); ++i) {
    check_points(lines.yarns[i], i, lines.yarns[i].closed ? 3 : 2 + outer);
  }
}

}  // namespace knitmech::curves
