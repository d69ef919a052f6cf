#include "picture/mm_axes.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/yarn_curve.h"
#include "picture/svg.h"

namespace knitmech::picture {
namespace {

using Eigen::Vector2d;

constexpr const char* kAxis = R"(stroke="#333333" stroke-width="1.2")";
constexpr double kTextSize = 14;

/// Points into which the curve of an element is cut, before those that are not needed go [-].
constexpr int kPointsPerElement = 6;

double distance_to_segment(const Vector2d& point, const Vector2d& start, const Vector2d& end) {
  const Vector2d direction = end - start;
  const double length_squared = direction.squaredNorm();
  const double share = length_squared > 0 ? (point - start).dot(direction) / length_squared : 0;
  return (point - start - std::min(1.0, std::max(0.0, share)) * direction).norm();
}

/// Marks the points that a line needs.
std::vector<bool> needed_points(const PlaneLine& line) {
  std::vector<bool> needed(line.size(), false);
  needed.front() = needed.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> parts{{0, line.size() - 1}};
  while (!parts.empty()) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    std::size_t farthest = first;
    double largest = kLineTolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_to_segment(line[i], line[first], line[last]);
      if (distance > largest) {
        largest = distance;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    needed[farthest] = true;
    parts.emplace_back(first, farthest);
    parts.emplace_back(farthest, last);
  }
  return needed;
}

}  // namespace

std::string axes_elements(const MmAxes& axes, const std::string& label_across, const std::string& label_up) {
  const double right = axes.left + axes.width();
  const double bottom = axes.top + axes.height();
  std::string text = line_element(axes.left, bottom, right, bottom, kAxis);
  text += line_element(axes.left, axes.top, axes.left, bottom, kAxis);
  for (std::size_t i = 0; i < axes.across.values.size(); ++i) {
    const double x = axes.place_of({axes.across.values[i], 0}).x();
    text += line_element(x, bottom, x, bottom + 5, kAxis);
    text += text_element(x, bottom + 21, kTextSize, "middle", axes.across.labels[i]);
  }
  for (std::size_t i = 0; i < axes.up.values.size(); ++i) {
    const double y = axes.place_of({0, axes.up.values[i]}).y();
    text += line_element(axes.left - 5, y, axes.left, y, kAxis);
    text += text_element(axes.left - 9, y + 5, kTextSize, "end", axes.up.labels[i]);
  }
  text += text_element(0.5 * (axes.left + right), bottom + 44, kTextSize, "middle", label_across);
  const double middle = 0.5 * (axes.top + bottom);
  text += text_element(20, middle, kTextSize, "middle", label_up,
                       fmt::format(R"~( transform="rotate(-90 20 {:.1f})")~", middle));
  return text;
}

std::vector<PlaneLine> centrelines(const model::Model& model, const model::Frame& frame, int across, int up) {
  std::vector<PlaneLine> lines;
  for (const model::CurvePiece& piece : model::yarn_curves(model, frame)) {
    if (lines.empty() || !piece.continues_piece_before) lines.push_back({{piece.start[across], piece.start[up]}});
    for (int k = 1; k <= kPointsPerElement; ++k) {
      const Eigen::Vector3d point = piece.point(static_cast<double>(k) / kPointsPerElement);
      lines.back().emplace_back(point[across], point[up]);
    }
  }
  return lines;
}

std::string polyline_element(const MmAxes& axes, const PlaneLine& line, const std::string& attributes) {
  PlaneLine places;
  places.reserve(line.size());
  for (const Vector2d& point : line) places.push_back(axes.place_of(point));
  const std::vector<bool> needed = needed_points(places);
  std::string points;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!needed[i]) continue;
    points += fmt::format("{}{:.2f},{:.2f}", points.empty() ? "" : " ", places[i].x(), places[i].y());
  }
  return fmt::format("<polyline points=\"{}\" {}/>\n", points, attributes);
}

}  // namespace knitmech::picture
