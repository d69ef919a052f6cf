#include "report/run_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/number_text.h"
#include "results/constants.h"

namespace knitmech::report {
namespace {

using model::HistoryRow;
using picture::Chart;
using picture::Series;

/// Width and height of a chart in a report [px].
constexpr int kWidth = 640, kHeight = 440;

constexpr double kSmallForce = 0.1;   ///< [N], below which forces are told in mN
constexpr double kLeastShown = 1e-4;  ///< share of the largest force at which a logarithmic axis ends [-]

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

/// The means over the 1 % of strain before each point (results::kWindow): on a logarithmic axis the waves of loose
/// yarns would hide the toe. What is below the least is a gap.
std::vector<double> without_waves(const std::vector<double>& percent, const std::vector<double>& values, double least) {
  std::vector<double> means(values.size());
  std::size_t first = 0;
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i];
    for (; percent[first] < percent[i] - 100 * results::kWindow; ++first) sum -= values[first];
    const double mean = sum / static_cast<double>(i - first + 1);
    means[i] = mean < least ? std::numeric_limits<double>::quiet_NaN() : mean;
  }
  return means;
}

}  // namespace

Chart force_chart(const std::vector<NamedHistory>& runs, bool logarithmic) {
  double most = 0;
  for (const NamedHistory& run : runs) most = std::max(most, largest(run.history, &HistoryRow::force_top));
  const bool in_millinewton = most < kSmallForce;
  const double scale = in_millinewton ? 1000 : 1;
  Chart chart = chart_over_strain(runs, in_millinewton ? "Grip force [mN]" : "Grip force [N]",
                                  [&](const HistoryRow& row) { return scale * row.force_top; });
  if (logarithmic) {
    for (Series& series : chart.series) {
      if (series.y.empty()) continue;
      series.y = without_waves(series.x, series.y, kLeastShown * *std::ranges::max_element(series.y));
    }
  }
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
