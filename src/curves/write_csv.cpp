#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "curves/write_lines.h"

namespace knitmech::curves {

std::string csv_text(const std::vector<YarnLine>& yarns) {
  const bool with_radius = std::ranges::all_of(yarns, [](const YarnLine& yarn) { return yarn.radius > 0; });
  std::string text = with_radius ? "yarn,x_mm,y_mm,z_mm,radius_mm\n" : "yarn,x_mm,y_mm,z_mm\n";
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < yarns.size(); ++i) {
    const auto write_point = [&](const Eigen::Vector3d& point) {
      fmt::format_to(out, "{},{},{},{}", i + 1, point.x(), point.y(), point.z());
      if (with_radius) fmt::format_to(out, ",{}", yarns[i].radius);
      text += '\n';
    };
    std::ranges::for_each(yarns[i].points, write_point);
    if (yarns[i].closed) write_point(yarns[i].points.front());
  }
  return text;
}

}  // namespace knitmech::curves
