#include "picture/chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace knitmech::picture {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Place {
  double x, y;
};

/// The points of every polyline of an SVG text.
std::vector<std::vector<Place>> polylines(const std::string& svg) {
  std::vector<std::vector<Place>> lines;
  static const std::regex kPolyline{"<polyline points=\"([^\"]*)\""};
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), kPolyline); it != std::sregex_iterator(); ++it) {
    std::istringstream points((*it)[1].str());
    std::vector<Place> line;
    Place place{};
    char comma = ' ';
    while (points >> place.x >> comma >> place.y) {
      line.push_back(place);
    }
    lines.push_back(line);
  }
  return lines;
}

/// Whether every tag is closed in order and no bare & is left.
bool is_well_formed(const std::string& xml) {
  static const std::regex kTag{R"re(<(/?)([A-Za-z?][\w]*)((?:\s+[\w:.-]+="[^"<]*")*)\s*(/?|\?)>)re"};
  static const std::regex kBareAmpersand{"&(?!amp;|lt;|gt;|quot;)"};
  std::vector<std::string> open;
  std::size_t tags = 0;
  for (auto it = std::sregex_iterator(xml.begin(), xml.end(), kTag); it != std::sregex_iterator(); ++it, ++tags) {
    const bool closes = (*it)[1].length() > 0;
    if (closes && (open.empty() || open.back() != (*it)[2])) {
      return false;
    }
    if (closes) {
      open.pop_back();
    } else if ((*it)[4].length() == 0) {
      open.push_back((*it)[2]);
    }
  }
  const auto brackets = static_cast<std::size_t>(std::count(xml.begin(), xml.end(), '<'));
  return open.empty() && tags == brackets && !std::regex_search(xml, kBareAmpersand);
}

Chart wavy_chart() {
  Chart chart{.title = "title", .x_label = "Strain [%]", .y_label = "Force [N]"};
  for (int s = 0; s < 7; ++s) {
    Series series{"series " + std::to_string(s), {}, {}};
    for (int i = 0; i <= 100; ++i) {
      series.x.push_back(0.22 * i);
      series.y.push_back((s + 1) * std::sin(0.1 * i));
    }
    chart.series.push_back(series);
  }
  return chart;
}

TEST(Chart, DrawsEveryPointOfEverySeriesWithinItsAxes) {
  // Given seven series, more than there are colours.
  const Chart chart = wavy_chart();
  const std::string svg = chart_svg(chart);
  const auto lines = polylines(svg);
  // Then each has all its points, between the left end of the x axis and the right, and above the x axis.
  ASSERT_EQ(lines.size(), 7U);
  static const std::regex kXAxis{
      "<line x1=\"([\\d.]+)\" y1=\"([\\d.]+)\" x2=\"([\\d.]+)\" y2=\"\\2\" stroke=\"#333333\" stroke-width=\"1.2\"/>\n"
      "<line x1=\"\\1\" y1=\"([\\d.]+)\" x2=\"\\1\" y2=\"\\2\""};
  std::smatch axes;
  ASSERT_TRUE(std::regex_search(svg, axes, kXAxis));
  for (const auto& line : lines) {
    ASSERT_EQ(line.size(), 101U);
    for (const Place& place : line) {
      EXPECT_GE(place.x, std::stod(axes[1]));
      EXPECT_LE(place.x, std::stod(axes[3]));
      EXPECT_LE(place.y, std::stod(axes[2]));
      EXPECT_GE(place.y, std::stod(axes[4]));
    }
  }
}

TEST(Chart, PutsPointsInProportion) {
  Chart chart;
  chart.series = {{"line", {0, 1, 2, 4}, {0, 10, 20, 40}}};
  const auto line = polylines(chart_svg(chart)).at(0);
  EXPECT_NEAR(line[3].x - line[0].x, 4 * (line[1].x - line[0].x), 0.05);
  EXPECT_NEAR(line[3].y - line[0].y, 2 * (line[2].y - line[0].y), 0.05);
  EXPECT_GT(line[1].x, line[0].x);
  EXPECT_LT(line[1].y, line[0].y) << "a larger value lies higher on the page";
}

TEST(Chart, PutsEqualFactorsAtEqualDistancesOnLogarithmicAxes) {
  Chart chart{.log_x = true, .log_y = true};
  // Given points on y = x^2, a factor of ten apart.
  chart.series = {{"line", {0.1, 1, 10, 100}, {0.01, 1, 100, 10000}}};
  const auto line = polylines(chart_svg(chart)).at(0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    EXPECT_NEAR(line[i].x - line[i - 1].x, line[1].x - line[0].x, 0.05);
    EXPECT_NEAR(line[i].y - line[i - 1].y, line[1].y - line[0].y, 0.05);
  }
  // And a point that has no logarithm, then there is a gap.
  chart.series[0].y[1] = 0;
  EXPECT_EQ(polylines(chart_svg(chart)).at(0).size(), 2U);
}

TEST(Chart, DrawsMarksInPlaceOfLinesAndNotesBesideThem) {
  Chart chart;
  chart.series = {{"circles", {0, 1, 2}, {0, 1, 2}, true}, {"squares", {0, 1}, {2, 1}, true}};
  chart.notes = {{1, 1, "at the right"}, {1, 1, "at the left", true}};
  const std::string svg = chart_svg(chart);
  EXPECT_TRUE(polylines(svg).empty());
  const auto count = [&](const std::string& what) {
    const std::regex pattern(what);
    return std::distance(std::sregex_iterator(svg.begin(), svg.end(), pattern), std::sregex_iterator());
  };
  EXPECT_EQ(count("<circle "), 3 + 1) << "one of them in the legend";
  EXPECT_EQ(count("<rect [^>]*width=\"7\""), 2 + 1);
  EXPECT_EQ(count("text-anchor=\"start\">at the right<"), 1);
  EXPECT_EQ(count("text-anchor=\"end\">at the left<"), 1);
}

TEST(Chart, ShadesABandBetweenItsTwoLinesBehindAllOthers) {
  // Given a line that runs in the middle of a band, which has a gap.
  const double gap = std::numeric_limits<double>::quiet_NaN();
  Chart chart;
  chart.series = {{"line", {0, 1, 2, 3, 4}, {10, 20, 30, 40, 50}}};
  chart.bands = {{"range", {0, 1, 2, 3, 4}, {0, 10, gap, 30, 40}, {20, 30, 40, 50, 60}}};
  std::string svg = chart_svg(chart);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_LT(svg.find("<polygon"), svg.find("<polyline"));
  EXPECT_THAT(svg, HasSubstr(">range<"));
  // Then there are two areas, along the low line and back along the high one, as far above as below the line.
  const auto line = polylines(svg).at(0);
  for (std::size_t at = svg.find("<polygon"); at != std::string::npos; at = svg.find("<polygon", at)) {
    svg.replace(at, 8, "<polyline");
  }
  const auto lines = polylines(svg);
  ASSERT_EQ(lines.size(), 3U);
  for (std::size_t area = 0; area < 2; ++area) {
    ASSERT_EQ(lines[area].size(), 4U);
    for (std::size_t i = 0; i < 2; ++i) {
      const Place& low = lines[area][i];
      const Place& high = lines[area][3 - i];
      const Place& middle = line[3 * area + i];
      EXPECT_NEAR(low.x, middle.x, 0.02);
      EXPECT_NEAR(high.x, middle.x, 0.02);
      EXPECT_NEAR(low.y - middle.y, middle.y - high.y, 0.03);
      EXPECT_GT(low.y - middle.y, 10);
    }
  }
  chart.bands[0].low.pop_back();
  EXPECT_THROW(static_cast<void>(chart_svg(chart)), std::invalid_argument);
}

TEST(Chart, LeavesSeriesWithoutANameOutOfTheLegend) {
  Chart chart;
  chart.series = {{"", {0, 1}, {0, 1}, true}, {"line", {0, 1}, {1, 2}}};
  const std::string svg = chart_svg(chart);
  EXPECT_THAT(svg, HasSubstr(">line<"));
  static const std::regex kCircle{"<circle "};
  EXPECT_EQ(std::distance(std::sregex_iterator(svg.begin(), svg.end(), kCircle), std::sregex_iterator()), 2);
}

TEST(Chart, SeveralStandOneBelowTheOther) {
  Chart upper = wavy_chart();
  upper.height = 300;
  const std::string svg = charts_svg({upper, wavy_chart()});
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("width=\"760\" height=\"800\""));
  EXPECT_THAT(svg, HasSubstr("<g transform=\"translate(0 300)\">"));
  EXPECT_EQ(polylines(svg).size(), 14U);
}

TEST(Chart, BeginsAtZeroIfOnlyNoiseIsBelowIt) {
  const auto with_least = [](double least) { return chart_svg({.series = {{"", {0, 1, 2}, {0, least, 8}}}}); };
  EXPECT_THAT(with_least(-0.1), Not(HasSubstr(">-2<")));
  EXPECT_THAT(with_least(-0.5), HasSubstr(">-2<"));
}

TEST(Chart, IsWellFormedWhateverTheTextSays) {
  Chart chart = wavy_chart();
  chart.title = "a < b & c > \"d\" \x01";
  chart.series[0].name = "</svg>";
  const std::string svg = chart_svg(chart);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c &gt; &quot;d&quot;"));
  EXPECT_THAT(svg, HasSubstr("&lt;/svg&gt;"));
}

TEST(Chart, NamesItsAxesAndItsSeries) {
  const std::string svg = chart_svg(wavy_chart());
  for (const char* text : {">title<", ">Strain [%]<", ">Force [N]<", ">series 0<", ">series 6<"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  Chart alone = wavy_chart();
  alone.series.resize(1);
  EXPECT_THAT(chart_svg(alone), Not(HasSubstr(">series 0<"))) << "a single line needs no legend";
}

TEST(Chart, LeavesAGapWhereAPointIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Chart chart;
  chart.series = {{"broken", {0, 1, 2, 3, 4, 5}, {0, 1, nan, 3, nan, 5}}};
  const std::string svg = chart_svg(chart);
  const auto lines = polylines(svg);
  ASSERT_EQ(lines.size(), 1U) << "the points 0 and 1; 3 and 5 stand alone";
  EXPECT_EQ(lines[0].size(), 2U);
  static const std::regex kCircle{"<circle "};
  EXPECT_EQ(std::distance(std::sregex_iterator(svg.begin(), svg.end(), kCircle), std::sregex_iterator()), 2);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Chart, SaysThatThereIsNoData) {
  EXPECT_THAT(chart_svg({}), HasSubstr("no data"));
  Chart chart;
  chart.series = {{"empty", {}, {}}};
  const std::string svg = chart_svg(chart);
  EXPECT_THAT(svg, HasSubstr("no data"));
  EXPECT_TRUE(is_well_formed(svg));
}

TEST(Chart, RefusesSeriesOfUnequalLength) {
  Chart chart;
  chart.series = {{"odd", {1, 2}, {1}}};
  EXPECT_THROW(static_cast<void>(chart_svg(chart)), std::invalid_argument);
}

TEST(Chart, GivenALimitWhenDrawnThenALineCrossesTheChartThereAndItsTextStandsBesideIt) {
  Chart chart{
      .x_label = "x", .y_label = "y", .series = {{"", {0, 10}, {0, 1}}}, .limits = {{5, "toe"}, {11, "beyond"}}};
  const std::string svg = chart_svg(chart);
  EXPECT_NE(svg.find(">toe</text>"), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray=\"3 3\""), std::string::npos);
  EXPECT_EQ(svg.find("beyond"), std::string::npos);
}

// Ten names of 30 letters are about 3000 px long; the chart is 640 px wide.
TEST(Chart, GivenALegendLongerThanTheChartWhenDrawnThenItGoesOnInTheNextRowAndNoEntryBeginsBeyondTheChart) {
  Chart chart{.x_label = "x", .y_label = "y", .width = 640, .height = 600};
  for (int i = 0; i < 10; ++i) chart.series.push_back({std::string(30, static_cast<char>('a' + i)), {0, 1}, {0, 1}});
  const std::string svg = chart_svg(chart);
  std::set<double> rows;
  for (int i = 0; i < 10; ++i) {
    const auto name = svg.find(std::string(30, static_cast<char>('a' + i)));
    ASSERT_NE(name, std::string::npos);
    const std::string element = svg.substr(svg.rfind("<text", name), 60);
    double x = 0, y = 0;
    ASSERT_EQ(std::sscanf(element.c_str(), "<text x=\"%lf\" y=\"%lf\"", &x, &y), 2) << element;
    EXPECT_LT(x + 150, 640);
    rows.insert(y);
  }
  EXPECT_GE(rows.size(), 5U);
}

}  // namespace
}  // namespace knitmech::picture
