#include "picture/chart.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "picture/svg.h"
#include "picture/ticks.h"

namespace knitmech::picture {
namespace {

/// Dark enough on white for a thin line, and distinguishable with any colour vision (M. Okabe and K. Ito, "Color
/// Universal Design", 2008). The dashes tell the lines apart in black-and-white print.
struct LineStyle {
  const char* colour;
  const char* dashes;
};
constexpr std::array<LineStyle, 6> kStyles{{{"#0072b2", ""},
                                            {"#d55e00", "7 4"},
                                            {"#009e73", "2 3"},
                                            {"#cc79a7", "10 3 2 3"},
                                            {"#56b4e9", ""},
                                            {"#000000", "7 4"}}};

constexpr double kTextSize = 14;
constexpr double kTitleSize = 16;
constexpr double kMarkSize = 3.5;
constexpr double kLegendText = 42;  ///< from the begin of an entry to its text [px]
constexpr double kLegendRow = 22;   ///< from one row of a legend to the next [px]
constexpr const char* kBandColour = "#d9d9d9";

/// Where things lie on the page [px].
struct Layout {
  double left = 78;
  double right = 0;
  double top = 0;
  double bottom = 0;
  double legend_y = 0;
  Ticks x;
  Ticks y;

  [[nodiscard]] double page_x(double value) const {
    return left + (value - x.first()) / (x.last() - x.first()) * (right - left);
  }
  [[nodiscard]] double page_y(double value) const {
    return bottom - (value - y.first()) / (y.last() - y.first()) * (bottom - top);
  }
};

struct Range {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void include(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
};

bool is_point(const Series& series, std::size_t i) {
  return std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
}

double logarithm(double value) {
  return value > 0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
}

/// A chart with the logarithms of what is drawn over logarithmic axes.
Chart on_axes(Chart chart) {
  for (Series& series : chart.series) {
    if (chart.log_x) std::transform(series.x.begin(), series.x.end(), series.x.begin(), logarithm);
    if (chart.log_y) std::transform(series.y.begin(), series.y.end(), series.y.begin(), logarithm);
  }
  for (Band& band : chart.bands) {
    if (chart.log_x) std::transform(band.x.begin(), band.x.end(), band.x.begin(), logarithm);
    for (std::vector<double>* values : {&band.low, &band.high}) {
      if (chart.log_y) std::transform(values->begin(), values->end(), values->begin(), logarithm);
    }
  }
  for (Limit& limit : chart.limits) {
    if (chart.log_x) limit.x = logarithm(limit.x);
  }
  for (Note& note : chart.notes) {
    if (chart.log_x) note.x = logarithm(note.x);
    if (chart.log_y) note.y = logarithm(note.y);
  }
  return chart;
}

bool is_point(const Band& band, std::size_t i) {
  return std::isfinite(band.x[i]) && std::isfinite(band.low[i]) && std::isfinite(band.high[i]);
}

void include_bands(const Chart& chart, Range& x, Range& y) {
  for (const Band& band : chart.bands) {
    if (band.low.size() != band.x.size() || band.high.size() != band.x.size()) {
      throw std::invalid_argument(fmt::format("The band \"{}\" has {} x, {} low and {} high.", band.name, band.x.size(),
                                              band.low.size(), band.high.size()));
    }
    for (std::size_t i = 0; i < band.x.size(); ++i) {
      if (!is_point(band, i)) continue;
      x.include(band.x[i]);
      y.include(band.low[i]);
      y.include(band.high[i]);
    }
  }
}

bool has_legend(const Chart& chart) {
  const auto n_named = std::ranges::count_if(chart.series, [](const Series& series) { return !series.name.empty(); });
  return (n_named > 0 && chart.series.size() > 1) || !chart.bands.empty();
}

/// Where the entries of a legend begin, one after the other.
class LegendCursor {
 public:
  LegendCursor(double left, double right, double y) : left_(left), right_(right), x_(left), y_(y) {}

  /// The place of the next entry: in the next row where it would not fit into this one.
  std::pair<double, double> place(const std::string& name) {
    // The reader's font is not known here: 0.62 of its size is a generous mean width of a letter.
    const double width = kLegendText + 0.62 * kTextSize * static_cast<double>(name.size());
    if (x_ > left_ && x_ + width > right_) {
      x_ = left_;
      y_ += kLegendRow;
    }
    const std::pair<double, double> at = {x_, y_};
    x_ += width + 24;
    return at;
  }

  [[nodiscard]] double y() const { return y_; }

 private:
  double left_, right_, x_, y_;
};

/// Height of a legend [px].
double legend_height(const Chart& chart, double left, double right) {
  LegendCursor cursor(left, right, 0);
  for (const Series& series : chart.series) {
    if (!series.name.empty()) cursor.place(series.name);
  }
  for (const Band& band : chart.bands) {
    if (!band.name.empty()) cursor.place(band.name);
  }
  return cursor.y() + kLegendRow + 4;
}

Layout lay_out(const Chart& chart) {
  Range x;
  Range y;
  for (const Series& series : chart.series) {
    if (series.x.size() != series.y.size()) {
      throw std::invalid_argument(
          fmt::format("The series \"{}\" has {} x and {} y.", series.name, series.x.size(), series.y.size()));
    }
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (is_point(series, i)) {
        x.include(series.x[i]);
        y.include(series.y[i]);
      }
    }
  }
  include_bands(chart, x, y);
  // Noise about zero, no thicker than a few lines, deserves no interval of its own below it.
  constexpr double kNoise = 0.02;
  if (!chart.log_y && y.lowest < 0 && -y.lowest < kNoise * y.highest) y.lowest = 0;
  Layout layout;
  layout.right = chart.width - 28.0;
  layout.top = chart.title.empty() ? 22.0 : 48.0;
  if (has_legend(chart)) {
    layout.legend_y = layout.top + 4;
    layout.top += legend_height(chart, layout.left, layout.right);
  }
  layout.bottom = chart.height - 60.0;
  layout.x = chart.log_x ? nice_log_ticks(x.lowest, x.highest) : nice_ticks(x.lowest, x.highest, 8);
  layout.y = chart.log_y ? nice_log_ticks(y.lowest, y.highest) : nice_ticks(y.lowest, y.highest, 6);
  return layout;
}

std::string axes(const Chart& chart, const Layout& layout) {
  constexpr const char* kGrid = R"(stroke="#e3e3e3" stroke-width="1")";
  constexpr const char* kAxis = R"(stroke="#333333" stroke-width="1.2")";
  std::string text;
  for (std::size_t i = 0; i < layout.x.values.size(); ++i) {
    const double x = layout.page_x(layout.x.values[i]);
    text += line_element(x, layout.top, x, layout.bottom, kGrid);
    text += line_element(x, layout.bottom, x, layout.bottom + 5, kAxis);
    text += text_element(x, layout.bottom + 21, kTextSize, "middle", layout.x.labels[i]);
  }
  for (std::size_t i = 0; i < layout.y.values.size(); ++i) {
    const double y = layout.page_y(layout.y.values[i]);
    text += line_element(layout.left, y, layout.right, y, kGrid);
    text += line_element(layout.left - 5, y, layout.left, y, kAxis);
    text += text_element(layout.left - 9, y + 5, kTextSize, "end", layout.y.labels[i]);
  }
  text += line_element(layout.left, layout.bottom, layout.right, layout.bottom, kAxis);
  text += line_element(layout.left, layout.top, layout.left, layout.bottom, kAxis);
  text += text_element(0.5 * (layout.left + layout.right), chart.height - 14.0, kTextSize, "middle", chart.x_label);
  const double middle = 0.5 * (layout.top + layout.bottom);
  text += text_element(20, middle, kTextSize, "middle", chart.y_label,
                       fmt::format(R"~( transform="rotate(-90 20 {:.1f})")~", middle));
  return text;
}

std::string stroke(std::size_t index) {
  const LineStyle& style = kStyles[index % kStyles.size()];
  std::string text = fmt::format(R"(fill="none" stroke="{}" stroke-width="{}" stroke-linejoin="round")", style.colour,
                                 kChartLineWidth);
  if (style.dashes[0] != '\0') {
    text += fmt::format(R"( stroke-dasharray="{}")", style.dashes);
  }
  return text;
}

/// Circles and squares in turn, which tell marks apart in black-and-white print.
std::string mark(double x, double y, std::size_t index) {
  const char* colour = kStyles[index % kStyles.size()].colour;
  if (index % 2 == 0) {
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\"/>\n", x, y, kMarkSize, colour);
  }
  return fmt::format("<rect x=\"{0:.2f}\" y=\"{1:.2f}\" width=\"{2}\" height=\"{2}\" fill=\"{3}\"/>\n", x - kMarkSize,
                     y - kMarkSize, 2 * kMarkSize, colour);
}

std::string series_marks(const Series& series, std::size_t index, const Layout& layout) {
  std::string text;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (is_point(series, i)) text += mark(layout.page_x(series.x[i]), layout.page_y(series.y[i]), index);
  }
  return text;
}

std::string note_text(const Note& note, const Layout& layout) {
  if (!std::isfinite(note.x) || !std::isfinite(note.y)) return "";
  constexpr double kAside = 3 * kMarkSize;
  return text_element(layout.page_x(note.x) + (note.at_left ? -kAside : kAside), layout.page_y(note.y) + 4,
                      kTextSize - 2, note.at_left ? "end" : "start", note.text);
}

/// One <polyline> for each run of finite points, or a dot where the run is a single point.
std::string series_lines(const Series& series, std::size_t index, const Layout& layout) {
  std::string text;
  std::size_t i = 0;
  while (i < series.x.size()) {
    std::string points;
    std::size_t count = 0;
    for (; i < series.x.size() && is_point(series, i); ++i, ++count) {
      points +=
          fmt::format("{}{:.2f},{:.2f}", count == 0 ? "" : " ", layout.page_x(series.x[i]), layout.page_y(series.y[i]));
    }
    if (count == 1) {
      text +=
          fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3.5\" fill=\"{}\"/>\n", layout.page_x(series.x[i - 1]),
                      layout.page_y(series.y[i - 1]), kStyles[index % kStyles.size()].colour);
    } else if (count > 1) {
      text += fmt::format("<polyline points=\"{}\" {}/>\n", points, stroke(index));
    } else {
      ++i;
    }
  }
  return text;
}

/// One <polygon> for each run of finite points: along the low line and back along the high one.
std::string band_areas(const Band& band, const Layout& layout) {
  std::string text;
  for (std::size_t begin = 0, end = 0; begin < band.x.size(); begin = end + 1) {
    for (end = begin; end < band.x.size() && is_point(band, end); ++end) continue;
    if (begin == end) continue;
    std::string points;
    const auto add = [&](std::size_t i, double value) {
      points += fmt::format("{:.2f},{:.2f} ", layout.page_x(band.x[i]), layout.page_y(value));
    };
    for (std::size_t i = begin; i < end; ++i) add(i, band.low[i]);
    for (std::size_t i = end; i > begin; --i) add(i - 1, band.high[i - 1]);
    text += fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", points, kBandColour);
  }
  return text;
}

std::string limit_line(const Limit& limit, const Layout& layout) {
  const double x = layout.page_x(limit.x);
  if (!std::isfinite(limit.x) || x < layout.left || x > layout.right) return "";
  constexpr const char* kLine = R"(stroke="#777777" stroke-width="1" stroke-dasharray="3 3")";
  return line_element(x, layout.top, x, layout.bottom, kLine) +
         text_element(x - 5, layout.top + 14, kTextSize - 2, "end", limit.text);
}

std::string legend(const Chart& chart, const Layout& layout) {
  std::string text;
  LegendCursor cursor(layout.left, layout.right, layout.legend_y);
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    if (chart.series[i].name.empty()) continue;
    const auto [x, y] = cursor.place(chart.series[i].name);
    text += chart.series[i].only_marks ? mark(x + 17, y, i) : line_element(x, y, x + 34, y, stroke(i).c_str());
    text += text_element(x + kLegendText, y + 5, kTextSize, "start", chart.series[i].name);
  }
  for (const Band& band : chart.bands) {
    if (band.name.empty()) continue;
    const auto [x, y] = cursor.place(band.name);
    text += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"34\" height=\"12\" fill=\"{}\"/>\n", x, y - 6,
                        kBandColour);
    text += text_element(x + kLegendText, y + 5, kTextSize, "start", band.name);
  }
  return text;
}

std::string chart_elements(const Chart& as_given) {
  const Chart chart = on_axes(as_given);
  const Layout layout = lay_out(chart);
  std::string text;
  if (!chart.title.empty()) {
    text += text_element(layout.left, 28, kTitleSize, "start", chart.title, " font-weight=\"bold\"");
  }
  for (const Band& band : chart.bands) text += band_areas(band, layout);
  text += axes(chart, layout);
  std::string lines;
  // The first series is the main one and lies on top.
  for (std::size_t i = chart.series.size(); i > 0; --i) {
    const Series& series = chart.series[i - 1];
    lines += series.only_marks ? series_marks(series, i - 1, layout) : series_lines(series, i - 1, layout);
  }
  if (lines.empty() && chart.bands.empty()) {
    lines = text_element(0.5 * (layout.left + layout.right), 0.5 * (layout.top + layout.bottom), kTitleSize, "middle",
                         "no data");
  }
  text += lines;
  for (const Limit& limit : chart.limits) text += limit_line(limit, layout);
  for (const Note& note : chart.notes) text += note_text(note, layout);
  if (has_legend(chart)) {
    text += legend(chart, layout);
  }
  return text;
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  return svg_document(chart.width, chart.height, chart_elements(chart));
}

std::string charts_svg(const std::vector<Chart>& charts) {
  int width = 0;
  int height = 0;
  std::string elements;
  for (const Chart& chart : charts) {
    elements += fmt::format("<g transform=\"translate(0 {})\">\n{}</g>\n", height, chart_elements(chart));
    width = std::max(width, chart.width);
    height += chart.height;
  }
  return svg_document(width, height, elements);
}

}  // namespace knitmech::picture
