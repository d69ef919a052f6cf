#include "app/yarn_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/run_texts.h"
#include "base/quantity.h"

namespace knitmech::app {
namespace {

using base::Dimension;

/// Poisson's ratio of a drawn polyamide monofilament, where none is given; a tensile test does not measure it.
constexpr double kAssumedPoissonsRatio = 0.39;

/// "18.9 N (18.1 N to 19.8 N)", the range only of several.
template <class Text>
std::string with_range(double mean, const std::vector<double>& values, Text text) {
  if (values.size() == 1) return text(mean);
  const auto [least, greatest] = std::ranges::minmax_element(values);
  return fmt::format("{} ({} to {})", text(mean), text(*least), text(*greatest));
}

std::string specimens_text(const YarnAnalysis& analysis) {
  std::string text;
  for (std::size_t i = 0; i < analysis.curves.size(); ++i) {
    const yarn::Break end = yarn::break_of(analysis.curves[i]);
    text += fmt::format("  {}: EA {}, breaks at {} and {}\n", analysis.curves[i].name, force_text(analysis.slopes[i]),
                        force_text(end.force), percent_text(end.strain));
  }
  return text;
}

std::string modulus_text(const YarnAnalysis& analysis) {
  const auto modulus = analysis.youngs_modulus();
  if (!modulus) return "not known without --diameter";
  return fmt::format("{:.4g} MPa for a full circle of {:.4g} mm", *modulus, *analysis.fineness.diameter);
}

/// 0 in place of what is only rounding beside a larger value.
double without_rounding(double value, double larger) {
  constexpr double kRounding = 1e-9;
  return std::abs(value) < kRounding * larger ? 0 : value;
}

/// Six digits in the usual unit, in quotes.
std::string quantity_text(double value, Dimension dimension) {
  const base::Unit& unit = base::units_of(dimension).front();
  return fmt::format("\"{:.6g} {}\"", value * unit.divide / unit.multiply, unit.name);
}

/// "name = [a, b, ...]" in lines of some entries.
template <class Text>
std::string array_text(const char* name, const std::vector<yarn::AxialPoint>& points, Text text) {
  constexpr std::size_t kEntriesInLine = 8;
  std::string result = fmt::format("{} = [", name);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const char* const before = i == 0 ? "" : ",";
    const char* const gap = i % kEntriesInLine == 0 ? "\n  " : " ";
    result += fmt::format("{}{}{}", before, gap, text(points[i]));
  }
  return result + "\n]\n";
}

std::string curve_text(const std::vector<yarn::AxialPoint>& law) {
  return array_text("curve_strains", law,
                    [](const yarn::AxialPoint& point) { return fmt::format("{}", point.strain); }) +
         array_text("curve_forces", law,
                    [](const yarn::AxialPoint& point) { return quantity_text(point.force, Dimension::force); });
}

}  // namespace

std::string yarn_text(const YarnAnalysis& analysis) {
  const yarn::LineFit& fit = analysis.fit;
  std::vector<double> forces;
  std::vector<double> strains;
  for (const yarn::TensileCurve& curve : analysis.curves) {
    forces.push_back(yarn::break_of(curve).force);
    strains.push_back(yarn::break_of(curve).strain);
  }
  std::string text = fmt::format("Tensile test of a yarn, {} specimen{}\n{}", analysis.curves.size(),
                                 analysis.curves.size() == 1 ? "" : "s", specimens_text(analysis));
  const auto add = [&](const char* name, const std::string& value) { text += fmt::format("  {:15}{}\n", name, value); };
  add("strength", fmt::format("{} at {}", with_range(analysis.mean_break.force, forces, force_text),
                              with_range(analysis.mean_break.strain, strains, percent_text)));
  if (analysis.fineness.linear_density) {
    constexpr double kPerCentinewtonPerTex = 1e10;
    add("tenacity", fmt::format("{:.4g} cN/tex",
                                analysis.mean_break.force / *analysis.fineness.linear_density / kPerCentinewtonPerTex));
  }
  add("EA", with_range(fit.slope, analysis.slopes, force_text));
  add("E", modulus_text(analysis));
  add("fit",
      fmt::format("from {} to {} strain, {} at strain 0", percent_text(fit.range.from), percent_text(fit.range.to),
                  force_text(without_rounding(fit.intercept, analysis.mean_break.force))));
  add("residual", fmt::format("R^2 {:.4f}, root mean square {:.2f} % of the largest force of the fit", fit.r_squared,
                              100 * fit.rms_ratio));
  if (!analysis.law.empty()) {
    const yarn::AxialLaw law(analysis.law);
    add("measured curve",
        fmt::format("{} points to {}; EA {} at strain 0, {} at most", analysis.law.size(),
                    percent_text(law.last_strain()), force_text(law.slope_at_zero()), force_text(law.largest_slope())));
  }
  for (const std::string& warning : analysis.warnings) text += fmt::format("Warning: {}.\n", warning);
  return text;
}

std::string yarn_section_block(const YarnAnalysis& analysis) {
  const auto modulus = analysis.youngs_modulus();
  if (!modulus || !analysis.fineness.density) return {};
  const std::size_t n = analysis.curves.size();
  std::string text = fmt::format(
      "# The yarn, from {} tensile test{}{}.\n[yarn]\n", n, n == 1 ? "" : "s",
      analysis.law.empty() ? fmt::format("; E from {} to {} strain, R^2 {:.4f}", percent_text(analysis.fit.range.from),
                                         percent_text(analysis.fit.range.to), analysis.fit.r_squared)
                           : "; the mean curve in place of E");
  const auto add = [&](const char* key, double value, Dimension dimension) {
    text += fmt::format("{} = {}\n", key, quantity_text(value, dimension));
  };
  add("diameter", *analysis.fineness.diameter, Dimension::length);
  add("density", *analysis.fineness.density, Dimension::density);
  if (analysis.law.empty()) add("youngs_modulus", *modulus, Dimension::pressure);
  text += fmt::format("poissons_ratio = {}{}\n", analysis.poissons_ratio.value_or(kAssumedPoissonsRatio),
                      analysis.poissons_ratio ? "" : "  # assumed: a tensile test does not measure it");
  if (!analysis.law.empty()) text += curve_text(analysis.law);
  add("strength", analysis.mean_break.force, Dimension::force);
  return text;
}

std::string mean_curve_csv(const yarn::MeanCurve& mean) {
  std::string text = "strain [-],mean force [N],least force [N],greatest force [N],specimens\n";
  for (std::size_t i = 0; i < mean.strains.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", yarn::six_digits(mean.strains[i]),
                   yarn::six_digits(mean.forces[i]), yarn::six_digits(mean.least[i]),
                   yarn::six_digits(mean.greatest[i]), mean.n_curves);
  }
  return text;
}

}  // namespace knitmech::app
