#include "yarn/yarn_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/errors.h"

namespace knitmech::yarn {
namespace {

/// Common strains of a mean curve: 16 steps between two points of the axial law, so that each is a mean of 17.
constexpr std::size_t kLawIntervals = 32;
constexpr std::size_t kStepsPerLawInterval = 16;
constexpr std::size_t kMeanIntervals = kLawIntervals * kStepsPerLawInterval;

/// Strains at which a line is fitted; more change the fit of a smooth curve by less than a thousandth.
constexpr int kFitPoints = 201;

/// Share of a wanted strain range that may be missing without a word [-].
constexpr double kMissingShare = 0.01;

std::ptrdiff_t index_of_largest(const std::vector<double>& forces) {
  return std::ranges::max_element(forces) - forces.begin();
}

double even(double from, double to, std::size_t i, std::size_t n_intervals) {
  if (i == n_intervals) return to;
  return from + (to - from) * static_cast<double>(i) / static_cast<double>(n_intervals);
}

/// Non-falling values nearest to the given ones in least squares, all of the same weight.
std::vector<double> pooled(const std::vector<double>& values) {
  struct Pool {
    double sum = 0;
    double count = 0;
    [[nodiscard]] double mean() const { return sum / count; }
  };
  std::vector<Pool> pools;
  for (const double value : values) {
    pools.push_back({value, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().sum += last.sum;
      pools.back().count += last.count;
    }
  }
  std::vector<double> result;
  for (const Pool& pool : pools) result.insert(result.end(), static_cast<std::size_t>(pool.count), pool.mean());
  return result;
}

/// Mean force from strain a to strain b.
double mean_force(const MeanCurve& mean, double a, double b) {
  double sum = 0;
  for (std::size_t i = 0; i <= kStepsPerLawInterval; ++i) {
    const double weight = i == 0 || i == kStepsPerLawInterval ? 0.5 : 1;  // trapezoidal rule
    sum += weight * force_at(mean.strains, mean.forces, even(a, b, i, kStepsPerLawInterval));
  }
  return sum / static_cast<double>(kStepsPerLawInterval);
}

/// Throws unless the strain gets on over the points up to the last by more than half of the range it covers on the way.
void check_strain_rises(const TensileCurve& curve, std::size_t last) {
  const auto end = curve.strains.begin() + static_cast<std::ptrdiff_t>(last) + 1;
  const auto [least, greatest] = std::minmax_element(curve.strains.begin(), end);
  if (curve.strains[last] - curve.strains[0] > (*greatest - *least) / 2) return;
  throw InputError(fmt::format(
      "{}: the strain is {:.4g} % at the first point and {:.4g} % at the largest force, point {}; it must rise "
      "with the test",
      curve.name, 100 * curve.strains[0], 100 * curve.strains[last], last + 1));
}

}  // namespace

TensileCurve up_to_break(const TensileCurve& curve) {
  const auto last = static_cast<std::size_t>(index_of_largest(curve.forces));
  if (!(curve.forces[last] > 0)) {
    throw InputError(fmt::format("{}: no force is above 0; a test in tension needs positive forces", curve.name));
  }
  check_strain_rises(curve, last);
  TensileCurve result{.name = curve.name,
                      .strains = {curve.strains[0]},
                      .forces = {curve.forces[0]},
                      .specimen = curve.specimen,
                      .per_width = curve.per_width};
  for (std::size_t i = 1; i <= last; ++i) {
    if (!(curve.strains[i] > result.strains.back())) continue;
    result.strains.push_back(curve.strains[i]);
    result.forces.push_back(curve.forces[i]);
  }
  result.forces.back() = curve.forces[last];
  return result;
}

TensileCurve without_slack(const TensileCurve& curve, double least_force) {
  auto first = static_cast<std::size_t>(index_of_largest(curve.forces));
  while (first > 0 && curve.forces[first - 1] >= least_force) --first;
  if (curve.forces[first] < least_force || first + 1 >= curve.forces.size()) {
    throw InputError(
        fmt::format("{}: the force does not stay at {} N or above over two points", curve.name, least_force));
  }
  const auto from = static_cast<std::ptrdiff_t>(first);
  TensileCurve result{.name = curve.name,
                      .strains = {curve.strains.begin() + from, curve.strains.end()},
                      .forces = {curve.forces.begin() + from, curve.forces.end()},
                      .specimen = curve.specimen,
                      .per_width = curve.per_width};
  for (double& strain : result.strains) strain -= curve.strains[first];
  return result;
}

Break break_of(const TensileCurve& curve) {
  return {curve.forces.back(), curve.strains.back()};
}

double force_at(std::span<const double> strains, std::span<const double> forces, double strain) {
  if (strain <= strains.front()) return forces.front();
  if (strain >= strains.back()) return forces.back();
  const auto i = static_cast<std::size_t>(std::ranges::upper_bound(strains, strain) - strains.begin());
  const double share = (strain - strains[i - 1]) / (strains[i] - strains[i - 1]);
  return forces[i - 1] + share * (forces[i] - forces[i - 1]);
}

MeanCurve mean_of(std::span<const TensileCurve> curves) {
  double from = 0;
  double to = break_of(curves.front()).strain;
  for (const TensileCurve& curve : curves) {
    from = std::max(from, curve.strains.front());
    to = std::min(to, break_of(curve).strain);
  }
  if (!(from < to)) {
    throw InputError(fmt::format("the curves have no strains in common: one begins at {:.4g} %, one breaks at {:.4g} %",
                                 100 * from, 100 * to));
  }
  MeanCurve mean;
  mean.n_curves = static_cast<int>(curves.size());
  for (std::size_t i = 0; i <= kMeanIntervals; ++i) {
    const double strain = even(from, to, i, kMeanIntervals);
    double sum = 0;
    double least = force_at(curves.front().strains, curves.front().forces, strain);
    double greatest = least;
    for (const TensileCurve& curve : curves) {
      const double force = force_at(curve.strains, curve.forces, strain);
      sum += force;
      least = std::min(least, force);
      greatest = std::max(greatest, force);
    }
    mean.strains.push_back(strain);
    mean.forces.push_back(sum / static_cast<double>(curves.size()));
    mean.least.push_back(least);
    mean.greatest.push_back(greatest);
  }
  return mean;
}

LineFit fit_line(std::span<const double> strains, std::span<const double> forces, StrainRange wanted) {
  LineFit fit;
  fit.range = {std::max(wanted.from, strains.front()), std::min(wanted.to, strains.back())};
  if (!(fit.range.from < fit.range.to)) {
    throw InputError(
        fmt::format("the curve has no strains from {:.4g} % to {:.4g} %, over which a line is to be fitted; it goes "
                    "from {:.4g} % to "
                    "{:.4g} %",
                    100 * wanted.from, 100 * wanted.to, 100 * strains.front(), 100 * strains.back()));
  }
  fit.covers = fit.range.to - fit.range.from >= (1 - kMissingShare) * (wanted.to - wanted.from);

  std::vector<double> x;
  std::vector<double> y;
  double mean_x = 0;
  double mean_y = 0;
  for (int i = 0; i < kFitPoints; ++i) {
    x.push_back(even(fit.range.from, fit.range.to, static_cast<std::size_t>(i), kFitPoints - 1));
    y.push_back(force_at(strains, forces, x.back()));
    mean_x += x.back() / kFitPoints;
    mean_y += y.back() / kFitPoints;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  const double largest = *std::ranges::max_element(y);
  if (!(xy > 0 && largest > 0)) {
    throw InputError(
        fmt::format("the force does not rise from {:.4g} % to {:.4g} % strain, so no line can be fitted there",
                    100 * fit.range.from, 100 * fit.range.to));
  }
  fit.slope = xy / xx;
  fit.intercept = mean_y - fit.slope * mean_x;
  double residual = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double difference = y[i] - fit.intercept - fit.slope * x[i];
    residual += difference * difference;
  }
  fit.r_squared = 1 - residual / yy;
  fit.rms_ratio = std::sqrt(residual / kFitPoints) / largest;
  return fit;
}

std::vector<AxialPoint> law_points(const MeanCurve& mean) {
  const double first = mean.strains.front();
  const double end = mean.strains.back();
  // A mean that begins later than at 0 says nothing of a force at 0; then there is none.
  const double at_zero = first > 0 ? 0 : mean.forces.front();
  const double half = end / static_cast<double>(kLawIntervals) / 2;
  std::vector<double> strains;
  std::vector<double> forces;
  for (std::size_t i = 1; i <= kLawIntervals; ++i) {
    const double strain = even(0, end, i, kLawIntervals);
    if (strain <= first) continue;
    const bool within = strain - half >= first && strain + half <= end;
    const double force =
        within ? mean_force(mean, strain - half, strain + half) : force_at(mean.strains, mean.forces, strain);
    strains.push_back(strain);
    forces.push_back(std::max(0.0, force - at_zero));
  }
  forces = pooled(forces);
  if (!(forces.front() > 0)) {
    throw InputError(fmt::format(
        "the mean force does not rise from strain 0 to {:.4g} %; take a slack start away by counting the strain "
        "from a small force",
        100 * strains.front()));
  }
  std::vector<AxialPoint> points = {{0, 0}};
  for (std::size_t i = 0; i < strains.size(); ++i) points.push_back({six_digits(strains[i]), six_digits(forces[i])});
  return points;
}

double six_digits(double value) {
  const std::string text = fmt::format("{:.5e}", value);
  double result = value;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

}  // namespace knitmech::yarn
