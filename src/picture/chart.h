#pragma once

#include <string>
#include <vector>

namespace knitmech::picture {

/// One line of a chart, or a row of marks. Points that are not finite leave a gap in the line. A series without a name
/// is not in the legend.
struct Series {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;  ///< as long as x
  bool only_marks = false;
};

/// The area between two lines over the same x, shaded, behind all lines. Points that are not finite interrupt it.
struct Band {
  std::string name;
  std::vector<double> x;
  std::vector<double> low, high;  ///< as long as x
};

/// Text beside a point of a chart, at its right or at its left.
struct Note {
  double x, y;
  std::string text;
  bool at_left = false;
};

/// A place on the x axis: a thin line across the chart, and a text at its upper end.
struct Limit {
  double x;
  std::string text;
};

/// A chart of lines over linear or logarithmic axes; on the latter, points that are not positive are gaps. Labels carry
/// their unit in brackets, as in "Strain [%]".
struct Chart {
  std::string title{};
  std::string x_label{};
  std::string y_label{};
  std::vector<Series> series{};
  std::vector<Band> bands{};
  std::vector<Note> notes{};
  std::vector<Limit> limits{};
  bool log_x = false, log_y = false;
  int width = 760;   ///< of the whole picture [px]
  int height = 500;  ///< [px]
};

/// Width of the lines of a chart [px].
inline constexpr double kChartLineWidth = 2.2;

/// A chart as an SVG document: lines in colours that colour-blind readers can tell apart and with different dashes,
/// axes with round numbers that enclose all points, a legend if there is more than one series
/// with a name or a band, in as many rows as it needs, text as text.
///
/// A series of one point is a dot; a chart without points says "no data". Any text is allowed in names and labels.
/// Throws std::invalid_argument if x and y of a series, or x, low and high of a band, differ in length.
[[nodiscard]] std::string chart_svg(const Chart& chart);

/// Several charts in one document, one below the other.
[[nodiscard]] std::string charts_svg(const std::vector<Chart>& charts);

}  // namespace knitmech::picture
