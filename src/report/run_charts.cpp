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

/// Least and greatest x of the nodes in each slice of the height.
struct Slices {
  double lowest = 0, thickness = 1;  ///< [mm]
  std::vector<double> left, right;   ///< [mm]
};

Slices slices_of(const std::vector<Eigen::Vector3d>& points, std::size_t n_slices) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double lowest = kFar, highest = -kFar;
  for (const Eigen::Vector3d& point : points) {
    if (!point.allFinite()) continue;
    lowest = std::min(lowest, point.y());
    highest = std::max(highest, point.y());
  }
  Slices slices{lowest, std::max((highest - lowest) / static_cast<double>(n_slices), 1e-9),
                std::vector<double>(n_slices, kFar), std::vector<double>(n_slices, -kFar)};
  for (const Eigen::Vector3d& point : points) {
    if (!point.allFinite()) continue;
    const auto i = std::min(static_cast<std::size_t>((point.y() - lowest) / slices.thickness), n_slices - 1);
    slices.left[i] = std::min(slices.left[i], point.x());
    slices.right[i] = std::max(slices.right[i], point.x());
  }
  return slices;
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
  Chart chart{.x_label = "Height [mm]", .y_label = "Width [mm]", .width = kWidth, .height = kHeight};
  const int last_course = model.course.empty() ? 0 : *std::ranges::max_element(model.course);
  const auto n_slices = static_cast<std::size_t>(std::max(last_course, 1)) + 1;
  for (const model::Frame& frame : frames) {
    const Slices slices = slices_of(frame.points, n_slices);
    Series series{base::percent_text(frame.history.strain), {}, {}};
    for (std::size_t i = 0; i < n_slices; ++i) {
      if (slices.left[i] > slices.right[i]) continue;
      series.x.push_back(slices.lowest + (static_cast<double>(i) + 0.5) * slices.thickness);
      series.y.push_back(slices.right[i] - slices.left[i]);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace knitmech::report
