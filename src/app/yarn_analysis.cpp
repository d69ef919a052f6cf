#include "app/yarn_analysis.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/option_quantity.h"
#include "base/errors.h"
#include "base/quantity.h"
#include "yarn/curve_file.h"
#include "yarn/tensile_curve.h"

namespace knitmech::app {
namespace {

using base::Dimension;

/// Slope at zero of the measured curve over that of the fit below which the start of the curve looks slack [-].
constexpr double kSlackSlope = 0.5;

yarn::StrainRange range_of(const YarnOptions& options) {
  const yarn::StrainRange range{options.range.front(), options.range.back()};
  if (range.from >= 0 && range.from < range.to && std::isfinite(range.to)) return range;
  throw InputError(
      fmt::format("--range: {} {} must be two strains, the first at least 0 and below the second, such as 0 0.1",
                  range.from, range.to));
}

void check_poissons_ratio(const std::optional<double>& ratio) {
  if (!ratio || (*ratio > -1 && *ratio <= 0.5)) return;
  throw InputError(fmt::format("--poissons-ratio: {} must be more than -1 and at most 0.5", *ratio));
}

std::vector<yarn::TensileCurve> read_curves(const YarnOptions& options, const yarn::TestFacts& facts) {
  const auto from_force = option_quantity("--from-force", options.from_force, Dimension::force);
  if (from_force && !(*from_force > 0)) throw InputError("--from-force: must be more than 0");
  std::vector<yarn::TensileCurve> curves;
  for (const std::string& file : options.files) {
    for (const yarn::TensileCurve& curve : yarn::read_tensile_curves(yarn::curve_file_bytes(file), file, facts)) {
      curves.push_back(yarn::up_to_break(from_force ? yarn::without_slack(curve, *from_force) : curve));
    }
  }
  return curves;
}

/// EA of each specimen over the range of the fit.
std::vector<double> slopes_of(const std::vector<yarn::TensileCurve>& curves, const yarn::StrainRange& range) {
  std::vector<double> slopes;
  for (const yarn::TensileCurve& curve : curves) {
    try {
      slopes.push_back(yarn::fit_line(curve.strains, curve.forces, range).slope);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", curve.name, error.what()));
    }
  }
  return slopes;
}

yarn::Break mean_break(const std::vector<yarn::TensileCurve>& curves) {
  yarn::Break mean;
  for (const yarn::TensileCurve& curve : curves) {
    const yarn::Break end = yarn::break_of(curve);
    mean.force += end.force / static_cast<double>(curves.size());
    mean.strain += end.strain / static_cast<double>(curves.size());
  }
  return mean;
}

std::vector<std::string> warnings_of(const YarnAnalysis& analysis, const yarn::StrainRange& wanted) {
  std::vector<std::string> warnings;
  const yarn::LineFit& fit = analysis.fit;
  if (!fit.covers) {
    warnings.push_back(
        fmt::format("E is wanted from {:.4g} % to {:.4g} %, but all curves are there only from {:.4g} % to "
                    "{:.4g} %; the fit is over these",
                    100 * wanted.from, 100 * wanted.to, 100 * fit.range.from, 100 * fit.range.to));
  }
  if (!analysis.law.empty()) {
    const double at_zero = yarn::AxialLaw(analysis.law).slope_at_zero();
    if (at_zero < kSlackSlope * fit.slope) {
      warnings.push_back(
          fmt::format("the curve begins with EA {:.4g} N, far below the {:.4g} N of the fit, and bending "
                      "follows the beginning; if that is slack, take it away with --from-force",
                      at_zero, fit.slope));
    }
  }
  return warnings;
}

}  // namespace

std::optional<double> YarnAnalysis::youngs_modulus() const {
  if (!fineness.diameter) return std::nullopt;
  return fit.slope / (std::numbers::pi / 4 * *fineness.diameter * *fineness.diameter);
}

YarnAnalysis analyse_yarn(const YarnOptions& options) {
  const yarn::StrainRange range = range_of(options);
  check_poissons_ratio(options.poissons_ratio);
  YarnAnalysis analysis;
  analysis.poissons_ratio = options.poissons_ratio;
  analysis.fineness = yarn::completed(
      {.diameter = option_quantity("--diameter", options.diameter, Dimension::length),
       .linear_density = option_quantity("--linear-density", options.linear_density, Dimension::linear_density),
       .density = option_quantity("--density", options.density, Dimension::density)});
  analysis.curves =
      read_curves(options, {.diameter = analysis.fineness.diameter,
                            .linear_density = analysis.fineness.linear_density,
                            .gauge_length = option_quantity("--gauge-length", options.gauge_length, Dimension::length),
                            .columns = {.load = options.load_column, .extension = options.extension_column}});
  analysis.mean = yarn::mean_of(analysis.curves);
  analysis.mean_break = mean_break(analysis.curves);
  analysis.fit = yarn::fit_line(analysis.mean.strains, analysis.mean.forces, range);
  analysis.slopes = slopes_of(analysis.curves, analysis.fit.range);
  if (options.curve) analysis.law = yarn::law_points(analysis.mean);
  analysis.warnings = warnings_of(analysis, range);
  return analysis;
}

}  // namespace knitmech::app
