#include "results/curve_measures.h"

#include <algorithm>
#include <cstddef>

#include "base/line_slope.h"
#include "results/constants.h"

namespace knitmech::results {
namespace {

using model::HistoryRow;
using Rows = std::vector<HistoryRow>;

std::size_t first_row_from(const Rows& history, double strain) {
  const auto row = std::ranges::lower_bound(history, strain, {}, &HistoryRow::strain);
  return static_cast<std::size_t>(row - history.begin());
}

/// Slope of the force around a strain between rows `after - 1` and `after` [N].
std::optional<double> force_slope(const Rows& history, double strain, std::size_t after) {
  const std::size_t begin = std::min(first_row_from(history, strain - kWindow / 2), after > 0 ? after - 1 : 0);
  std::size_t end = std::max(first_row_from(history, strain + kWindow / 2), after + 1);
  if (history[after].strain == strain) end = std::max(end, after + 2);
  end = std::min(end, history.size());
  std::vector<double> strains;
  std::vector<double> forces;
  for (std::size_t i = begin; i < end; ++i) {
    strains.push_back(history[i].strain);
    forces.push_back(curve_force(history[i]));
  }
  return base::line_slope(strains, forces);
}

}  // namespace

double curve_force(const HistoryRow& row) {
  return 0.5 * (row.force_top + row.force_bottom);
}

std::optional<CurveMeasure> measure_at(const Rows& history, double strain) {
  if (history.empty() || !(strain >= history.front().strain && strain <= history.back().strain)) return std::nullopt;
  const std::size_t after = first_row_from(history, strain);
  const HistoryRow& b = history[after];
  const HistoryRow& a = after > 0 ? history[after - 1] : b;
  const double share = b.strain > a.strain ? (strain - a.strain) / (b.strain - a.strain) : 1.0;
  const double start_width = history.front().width;

  CurveMeasure measure{.strain = strain};
  measure.force = curve_force(a) + share * (curve_force(b) - curve_force(a));
  measure.force_per_width = measure.force / start_width;
  measure.width = a.width + share * (b.width - a.width);
  measure.contraction = (start_width - measure.width) / start_width;
  if (const auto slope = force_slope(history, strain, after)) measure.tangent = *slope / start_width;
  if (strain > 0) {
    measure.secant = measure.force_per_width / strain;
    measure.poissons_ratio = measure.contraction / strain;
  }
  return measure;
}

std::vector<CurveMeasure> curve_measures(const Rows& history) {
  std::vector<CurveMeasure> measures;
  measures.reserve(history.size());
  for (const HistoryRow& row : history) {
    if (const auto measure = measure_at(history, row.strain)) measures.push_back(*measure);
  }
  return measures;
}

}  // namespace knitmech::results
