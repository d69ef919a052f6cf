#include "picture/force_strain.h"

#include <algorithm>
#include <cmath>

#include "results/atomic_file.h"

namespace knitmech::picture {

Chart force_strain_chart(const std::vector<model::HistoryRow>& history, const std::string& title) {
  double largest = 0;
  double largest_difference = 0;
  for (const model::HistoryRow& row : history) {
    largest = std::max({largest, std::abs(row.force_top), std::abs(row.force_bottom)});
    largest_difference = std::max(largest_difference, std::abs(row.force_top - row.force_bottom));
  }
  constexpr double kSmallForce = 0.1;  // [N]
  const bool in_millinewton = largest < kSmallForce;
  const double scale = in_millinewton ? 1000 : 1;
  Series top{"top grip (driven)", {}, {}};
  Series bottom{"bottom grip (held)", {}, {}};
  for (const model::HistoryRow& row : history) {
    for (Series* series : {&top, &bottom}) {
      series->x.push_back(100 * row.strain);
    }
    top.y.push_back(scale * row.force_top);
    bottom.y.push_back(scale * row.force_bottom);
  }
  Chart chart{.title = title,
              .x_label = "Strain [%]",
              .y_label = in_millinewton ? "Grip force [mN]" : "Grip force [N]",
              .series = {std::move(top)}};
  if (largest_difference * chart.height > kChartLineWidth * largest) {
    chart.series.push_back(std::move(bottom));
  }
  return chart;
}

void write_force_strain_chart(const std::filesystem::path& path, const std::vector<model::HistoryRow>& history,
                              const std::string& title) {
  results::write_file_atomically(path, chart_svg(force_strain_chart(history, title)));
}

}  // namespace knitmech::picture
