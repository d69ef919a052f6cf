#include "picture/side_profile.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/errors.h"
#include "picture/mm_axes.h"
#include "picture/svg.h"

namespace knitmech::picture {
namespace {

using Eigen::Vector2d;

constexpr const char* kYarn = R"(fill="none" stroke="#b5b5b5" stroke-width="0.8" stroke-linejoin="round")";
constexpr const char* kHighest = R"(fill="none" stroke="#d55e00" stroke-width="2.2" stroke-linejoin="round")";
constexpr const char* kLowest =
    R"(fill="none" stroke="#0072b2" stroke-width="2.2" stroke-linejoin="round" stroke-dasharray="7 4")";
constexpr double kFieldWidth = 800;   // [px]
constexpr double kFieldHeight = 320;  // [px]
constexpr double kTextSize = 14;

/// Steps of y for the envelope [-]; usual 150. More follow the single loops, fewer the fabric.
constexpr std::size_t kSteps = 150;

/// Lowest and highest z of one step of y; not a range where no yarn passes.
struct Step {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void include(double z) {
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
  }
};

struct Envelope {
  double first = 0, length = 1;  ///< of y [mm]
  std::vector<Step> steps = std::vector<Step>(kSteps);

  explicit Envelope(const std::vector<PlaneLine>& lines) {
    Step y;
    for (const PlaneLine& line : lines) {
      for (const Vector2d& point : line) y.include(point.x());
    }
    first = y.lowest;
    length = std::max(y.highest - y.lowest, std::numeric_limits<double>::min());
    for (const PlaneLine& line : lines) {
      for (const Vector2d& point : line) step_at(point.x()).include(point.y());
    }
  }

  /// Middles of the steps with one of their ends.
  [[nodiscard]] PlaneLine line(double Step::*end) const {
    PlaneLine points;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (std::isfinite(steps[i].*end))
        points.emplace_back(first + (static_cast<double>(i) + 0.5) * length / kSteps, steps[i].*end);
    }
    return points;
  }

 private:
  Step& step_at(double y) {
    const auto index = static_cast<std::size_t>(std::max(0.0, (y - first) / length * kSteps));
    return steps[std::min(index, kSteps - 1)];
  }
};

/// The ends of z are those of the envelope.
MmAxes profile_axes(const Envelope& envelope, const PlaneLine& lowest, const PlaneLine& highest) {
  const auto by_z = [](const Vector2d& a, const Vector2d& b) { return a.y() < b.y(); };
  MmAxes axes;
  axes.across = nice_ticks(envelope.first, envelope.first + envelope.length, 8);
  axes.up = nice_ticks(std::min_element(lowest.begin(), lowest.end(), by_z)->y(),
                       std::max_element(highest.begin(), highest.end(), by_z)->y(), 6);
  axes.px_per_mm_across = kFieldWidth / (axes.across.last() - axes.across.first());
  axes.px_per_mm_up = kFieldHeight / (axes.up.last() - axes.up.first());
  axes.top = 80;
  return axes;
}

std::string legend(const MmAxes& axes) {
  constexpr double kRow = 55;  // [px]
  const double left = axes.left;
  std::string text = line_element(left, kRow, left + 34, kRow, kHighest);
  text += text_element(left + 42, kRow + 5, kTextSize, "start", "highest z");
  text += line_element(left + 140, kRow, left + 174, kRow, kLowest);
  text += text_element(left + 182, kRow + 5, kTextSize, "start", "lowest z");
  text += line_element(left + 280, kRow, left + 314, kRow, kYarn);
  text += text_element(left + 322, kRow + 5, kTextSize, "start", "yarns");
  text += text_element(left + axes.width(), kRow + 5, kTextSize, "end",
                       fmt::format("z drawn {:.2g} times as large as y", axes.px_per_mm_up / axes.px_per_mm_across));
  return text;
}

}  // namespace

std::string side_profile_svg(const model::Model& model, const model::Frame& frame, const std::string& caption) {
  const std::vector<PlaneLine> lines = centrelines(model, frame, 1, 2);
  if (lines.empty()) {
    throw InputError(
        fmt::format("Frame {} has no yarn whose position is known, so there is nothing to draw.", frame.index));
  }
  const Envelope envelope(lines);
  const PlaneLine lowest = envelope.line(&Step::lowest);
  const PlaneLine highest = envelope.line(&Step::highest);
  const MmAxes axes = profile_axes(envelope, lowest, highest);
  std::string text = text_element(axes.left, 28, kTextSize + 2, "start", caption, " font-weight=\"bold\"");
  text += legend(axes);
  text += axes_elements(axes, "y [mm]", "z [mm]");
  for (const PlaneLine& line : lines) text += polyline_element(axes, line, kYarn);
  text += polyline_element(axes, lowest, kLowest) + polyline_element(axes, highest, kHighest);
  return svg_document(static_cast<int>(std::ceil(axes.left + axes.width() + 30)),
                      static_cast<int>(std::ceil(axes.top + axes.height() + 60)), text);
}

}  // namespace knitmech::picture
