#include "picture/comparison_chart.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace knitmech::picture {
namespace {

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(factor * value);
  return result;
}

double largest_of(const compare::Comparison& comparison) {
  return std::max(*std::ranges::max_element(comparison.simulated), *std::ranges::max_element(comparison.highest));
}

}  // namespace

Chart comparison_chart(const compare::Comparison& comparison, const std::string& title, double width) {
  constexpr double kSmall = 0.1;  // [N] or [N/mm]
  double scale = width > 0 ? width : 1;
  const bool in_milli = scale * largest_of(comparison) < kSmall;
  if (in_milli) scale *= 1000;
  const std::vector<double> percent = scaled(comparison.strains, 100);
  Chart chart{.title = title,
              .x_label = comparison.offset == 0
                             ? "Strain [%]"
                             : fmt::format("Strain [%], the measured one less {:.3g}", 100 * comparison.offset),
              .y_label = fmt::format("{} [{}N{}]", width > 0 ? "Force" : "Force per width", in_milli ? "m" : "",
                                     width > 0 ? "" : "/mm")};
  chart.series.push_back({"simulated", percent, scaled(comparison.simulated, scale)});
  const int n = comparison.n_specimens;
  chart.series.push_back(
      {n > 1 ? fmt::format("mean of {} measured", n) : "measured", percent, scaled(comparison.mean, scale)});
  if (n > 1) {
    chart.bands.push_back(
        {"lowest to highest", percent, scaled(comparison.lowest, scale), scaled(comparison.highest, scale)});
  }
  return chart;
}

}  // namespace knitmech::picture
