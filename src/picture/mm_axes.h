#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "model/frame.h"
#include "model/model.h"
#include "picture/ticks.h"

namespace knitmech::picture {

/// Two axes in mm on an SVG page, and lines of yarn over them. Lengths on the page in px.
struct MmAxes {
  Ticks across, up;  ///< [mm]
  double left = 70;  ///< of the field between the axes
  double top = 90;
  double px_per_mm_across = 1, px_per_mm_up = 1;

  [[nodiscard]] double width() const { return (across.last() - across.first()) * px_per_mm_across; }
  [[nodiscard]] double height() const { return (up.last() - up.first()) * px_per_mm_up; }
  /// Place on the page of a point [mm].
  [[nodiscard]] Eigen::Vector2d place_of(const Eigen::Vector2d& point) const {
    return {left + (point.x() - across.first()) * px_per_mm_across, top + (up.last() - point.y()) * px_per_mm_up};
  }
};

/// The axes with ticks, numbers and labels such as "x [mm]".
[[nodiscard]] std::string axes_elements(const MmAxes& axes, const std::string& label_across,
                                        const std::string& label_up);

/// The centrelines of a frame as seen along one axis of space: a row of points [mm] per piece of yarn that is whole.
/// across, up: the axes of space (0 x, 1 y, 2 z) that point to the right and upwards on the page.
using PlaneLine = std::vector<Eigen::Vector2d>;
[[nodiscard]] std::vector<PlaneLine> centrelines(const model::Model& model, const model::Frame& frame, int across,
                                                 int up);

/// A line on the page with as few of its points as it needs: none that is left out is farther than kLineTolerance from
/// what remains (U. Ramer 1972; D. Douglas and T. Peucker 1973).
[[nodiscard]] std::string polyline_element(const MmAxes& axes, const PlaneLine& line, const std::string& attributes);

/// [px]; usual 0.1, below what is seen. Larger makes smaller files.
inline constexpr double kLineTolerance = 0.1;

}  // namespace knitmech::picture
