#pragma once

#include <string>
#include <vector>

namespace knitmech::picture {

/// One line of a chart. Points that are not finite leave a gap in the line.
struct Series {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;  ///< as long as x
};

/// A chart of lines over linear axes. Labels carry their unit in brackets, as in "Strain [%]".
struct Chart {
  std::string title{};
  std::string x_label{};
  std::string y_label{};
  std::vector<Series> series{};
  int width = 760;   ///< of the whole picture [px]
  int height = 500;  ///< [px]
};

/// Width of the lines of a chart [px].
inline constexpr double kChartLineWidth = 2.2;

/// A chart as an SVG document: lines in colours that colour-blind readers can tell apart and with different dashes,
/// axes with round numbers that enclose all points, a legend if there is more than one series, text as text.
///
/// A series of one point is a dot; a chart without points says "no data". Any text is allowed in names and labels.
/// Throws std::invalid_argument if x and y of a series differ in length.
[[nodiscard]] std::string chart_svg(const Chart& chart);

}  // namespace knitmech::picture
