#include "app/yarn_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace knitmech::app {
namespace {

/// More points than this do not show in a picture of this width.
constexpr std::size_t kPointsOfCurve = 400;

void add_point(picture::Series& series, double strain, double force) {
  series.x.push_back(100 * strain);
  series.y.push_back(force);
}

picture::Series mean_series(const yarn::MeanCurve& mean) {
  picture::Series series{fmt::format("mean of {}", mean.n_curves), {}, {}};
  for (std::size_t i = 0; i < mean.strains.size(); ++i) add_point(series, mean.strains[i], mean.forces[i]);
  return series;
}

picture::Series fit_series(const yarn::LineFit& fit) {
  picture::Series series{fmt::format("fit, EA {:.3g} N", fit.slope), {}, {}};
  for (const double strain : {fit.range.from, fit.range.to})
    add_point(series, strain, fit.intercept + fit.slope * strain);
  return series;
}

picture::Series law_series(const std::vector<yarn::AxialPoint>& points) {
  const yarn::AxialLaw law(points);
  picture::Series series{"law of the yarn", {}, {}};
  for (std::size_t i = 0; i <= kPointsOfCurve; ++i) {
    const double strain = law.last_strain() * static_cast<double>(i) / static_cast<double>(kPointsOfCurve);
    add_point(series, strain, law.force(strain));
  }
  return series;
}

picture::Series specimens_series(const std::vector<yarn::TensileCurve>& curves) {
  picture::Series series{curves.size() == 1 ? "specimen" : fmt::format("{} specimens", curves.size()), {}, {}};
  for (const yarn::TensileCurve& curve : curves) {
    const std::size_t stride = std::max<std::size_t>(1, curve.strains.size() / kPointsOfCurve);
    for (std::size_t i = 0; i + 1 < curve.strains.size(); i += stride) {
      add_point(series, curve.strains[i], curve.forces[i]);
    }
    add_point(series, curve.strains.back(), curve.forces.back());
    const double gap = std::numeric_limits<double>::quiet_NaN();
    add_point(series, gap, gap);
  }
  return series;
}

}  // namespace

picture::Chart yarn_chart(const YarnAnalysis& analysis) {
  picture::Chart chart{.title = "Tensile test of the yarn", .x_label = "Strain [%]", .y_label = "Force [N]"};
  chart.series.push_back(mean_series(analysis.mean));
  chart.series.push_back(analysis.law.empty() ? fit_series(analysis.fit) : law_series(analysis.law));
  chart.series.push_back(specimens_series(analysis.curves));
  constexpr double kSmallForce = 0.1;  // [N]
  if (analysis.mean_break.force < kSmallForce) {
    chart.y_label = "Force [mN]";
    for (picture::Series& series : chart.series) {
      for (double& force : series.y) force *= 1000;
    }
  }
  return chart;
}

}  // namespace knitmech::app
