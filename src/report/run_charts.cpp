#include "report/run_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/number_text.h"

namespace knitmech::report {
namespace {

using model::HistoryRow;
using picture::Chart;
using picture::Series;

/// Width and height of a chart in a report [px].
constexpr int kWidth = 640, kHeight = 440;

constexpr double kSmallForce = 0.1;  ///< [N], below which forces are told in mN

/// A line over strain [%] of what a function makes of each row.
template <class ValueOf>
Series series_over_strain(const std::string& name, const std::vector<HistoryRow>& history, const ValueOf& value_of) {
  Series series{name, {}, {}};
  for (const HistoryRow& row : history) {
    series.x.push_back(100 * row.strain);
    series.y.push_back(value_of(row));
  }
  return series;
}

template <class ValueOf>
Chart chart_over_strain(const std::vector<NamedHistory>& runs, const char* y_label, const ValueOf& value_of) {
  Chart chart{.x_label = "Strain [%]", .y_label = y_label, .width = kWidth, .height = kHeight};
  for (const NamedHistory& run : runs) {
    chart.series.push_back(series_over_strain(run.name, run.history, value_of));
  }
  return chart;
}

double largest(const std::vector<HistoryRow>& history, double HistoryRow::*member) {
  double result = 0;
  for (const HistoryRow& row : history) result = std::max(result, std::abs(row.*member));
  return result;
}

/// The nodes of one course, as far as their position is finite.
struct CourseExtent {
  double left = std::numeric_limits<double>::infinity();    ///< [mm]
  double right = -std::numeric_limits<double>::infinity();  ///< [mm]
  double height = 0;                                        ///< [mm], summed over the nodes
  int n_nodes = 0;
};

std::vector<CourseExtent> course_extents(const model::Model& model, const model::Frame& frame) {
  std::vector<CourseExtent> courses;
  for (std::size_t node = 0; node < frame.points.size(); ++node) {
    const Eigen::Vector3d& point = frame.points[node];
    if (!point.allFinite()) continue;
    const auto course = static_cast<std::size_t>(model.course[node]);
    if (course >= courses.size()) courses.resize(course + 1);
    CourseExtent& extent = courses[course];
    extent.left = std::min(extent.left, point.x());
    extent.right = std::max(extent.right, point.x());
    extent.height += point.y();
    ++extent.n_nodes;
  }
  return courses;
}

}  // namespace

Chart force_chart(const std::vector<NamedHistory>& runs, bool logarithmic) {
  double most = 0;
  for (const NamedHistory& run : runs) most = std::max(most, largest(run.history, &HistoryRow::force_top));
  const bool in_millinewton = most < kSmallForce;
  const double scale = in_millinewton ? 1000 : 1;
  // Far below the largest force there is nothing but the motion of loose yarns.
  const double least = logarithmic ? 1e-4 * most : -std::numeric_limits<double>::infinity();
  Chart chart =
      chart_over_strain(runs, in_millinewton ? "Grip force [mN]" : "Grip force [N]", [&](const HistoryRow& row) {
        return row.force_top < least ? std::numeric_limits<double>::quiet_NaN() : scale * row.force_top;
      });
  chart.log_y = logarithmic;
  return chart;
}

Chart work_chart(const std::vector<NamedHistory>& runs) {
  return chart_over_strain(runs, "Work of the grip [mJ]", [](const HistoryRow& row) { return row.external_work; });
}

Chart contraction_chart(const std::vector<NamedHistory>& runs) {
  Chart chart = chart_over_strain({}, "Contraction of the width [%]", [](const HistoryRow&) { return 0.0; });
  for (const NamedHistory& run : runs) {
    const double first = run.history.empty() ? 1 : run.history.front().width;
    chart.series.push_back(series_over_strain(
        run.name, run.history, [&](const HistoryRow& row) { return 100 * (first - row.width) / first; }));
  }
  return chart;
}

Chart energy_chart(const std::vector<HistoryRow>& history) {
  constexpr double kNegligible = 0.005;
  const std::vector<std::pair<const char*, double HistoryRow::*>> shares = {
      {"work of the grip", &HistoryRow::external_work},    {"stored in the yarns", &HistoryRow::internal_energy},
      {"lost to friction", &HistoryRow::friction_loss},    {"motion", &HistoryRow::kinetic_energy},
      {"stored in contacts", &HistoryRow::contact_energy}, {"lost to damping", &HistoryRow::damping_loss},
      {"lost in breaks", &HistoryRow::break_loss}};
  Chart chart{.x_label = "Strain [%]", .y_label = "Energy [mJ]", .width = kWidth, .height = kHeight};
  const double work = largest(history, &HistoryRow::external_work);
  for (const auto& [name, member] : shares) {
    if (largest(history, member) < kNegligible * work) continue;
    chart.series.push_back(series_over_strain(name, history, [m = member](const HistoryRow& row) { return row.*m; }));
  }
  return chart;
}

Chart contact_chart(const std::vector<NamedHistory>& runs) {
  return chart_over_strain(runs, "Contacts [-]",
                           [](const HistoryRow& row) { return static_cast<double>(row.contacts); });
}

Chart width_profile_chart(const model::Model& model, const std::vector<model::Frame>& frames) {
  Chart chart{.x_label = "Mean height of the course [mm]", .y_label = "Width [mm]", .width = kWidth, .height = kHeight};
  for (const model::Frame& frame : frames) {
    Series series{base::percent_text(frame.history.strain), {}, {}};
    for (const CourseExtent& course : course_extents(model, frame)) {
      if (course.n_nodes == 0) continue;
      series.x.push_back(course.height / course.n_nodes);
      series.y.push_back(course.right - course.left);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace knitmech::report
