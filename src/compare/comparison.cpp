#include "compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/errors.h"
#include "compare/constants.h"
#include "compare/least_of.h"

namespace knitmech::compare {
namespace {

using yarn::MeanCurve;
using yarn::StrainRange;

StrainRange common_range(const SimulatedCurve& simulated, const MeanCurve& measured, double offset) {
  return {std::max(simulated.strains.front(), measured.strains.front() - offset),
          std::min(simulated.strains.back(), measured.strains.back() - offset)};
}

std::vector<double> grid_of(const StrainRange& range) {
  std::vector<double> strains(kGridIntervals + 1);
  for (std::size_t i = 0; i <= kGridIntervals; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kGridIntervals);
    strains[i] = range.from + (range.to - range.from) * share;
  }
  strains.back() = range.to;
  return strains;
}

std::vector<double> forces_at(const std::vector<double>& grid, double offset, const std::vector<double>& strains,
                              const std::vector<double>& forces, double divisor) {
  std::vector<double> result;
  result.reserve(grid.size());
  for (const double strain : grid) result.push_back(yarn::force_at(strains, forces, strain + offset) / divisor);
  return result;
}

/// Mean over the strain by the trapezoidal rule on an even grid.
template <class Value>
double mean_over_grid(Value value) {
  double sum = 0;
  for (std::size_t i = 0; i <= kGridIntervals; ++i) {
    sum += (i == 0 || i == kGridIntervals ? 0.5 : 1.0) * value(i);
  }
  return sum / static_cast<double>(kGridIntervals);
}

/// The curves on the common grid, and how far they are apart.
void lay_over(const SimulatedCurve& simulated, const MeanCurve& measured, const StrainRange& range,
              Comparison& result) {
  result.strains = grid_of(range);
  result.simulated = forces_at(result.strains, 0, simulated.strains, simulated.forces, simulated.width);
  result.mean = forces_at(result.strains, result.offset, measured.strains, measured.forces, 1);
  const double mean_square = mean_over_grid([&](std::size_t i) {
    const double difference = result.simulated[i] - result.mean[i];
    return difference * difference;
  });
  result.rms = std::sqrt(mean_square);
  result.largest_force = *std::ranges::max_element(result.mean);
  result.rms_ratio =
      result.largest_force > 0 ? result.rms / result.largest_force : std::numeric_limits<double>::infinity();
}

/// The offset with the least rms_ratio of those that leave enough in common.
double best_offset(const SimulatedCurve& simulated, const MeanCurve& measured) {
  const double shorter = std::min(simulated.strains.back() - simulated.strains.front(),
                                  measured.strains.back() - measured.strains.front());
  const double overlap = kLeastOverlap * shorter;
  const double from = measured.strains.front() - simulated.strains.back() + overlap;
  const double to = measured.strains.back() - simulated.strains.front() - overlap;
  return least_of(from, to, kOffsetsTried, [&](double offset) {
    Comparison trial;
    trial.offset = offset;
    lay_over(simulated, measured, common_range(simulated, measured, offset), trial);
    return trial.rms_ratio;
  });
}

std::string range_text(double from, double to) {
  return fmt::format("from {:.4g} % to {:.4g} %", 100 * from, 100 * to);
}

void check_in_common(const SimulatedCurve& simulated, const MeanCurve& measured, const StrainRange& range,
                     double offset) {
  if (range.from < range.to) return;
  throw InputError(
      fmt::format("the curves have no strains in common: the simulated one goes {}, the measured ones {}{}",
                  range_text(simulated.strains.front(), simulated.strains.back()),
                  range_text(measured.strains.front() - offset, measured.strains.back() - offset),
                  offset == 0 ? "" : " less the offset"));
}

DifferenceAt difference_at(const Comparison& result, double strain) {
  const auto value = [&](const std::vector<double>& forces) { return yarn::force_at(result.strains, forces, strain); };
  DifferenceAt here{.strain = strain,
                    .simulated = value(result.simulated),
                    .mean = value(result.mean),
                    .lowest = value(result.lowest),
                    .highest = value(result.highest)};
  here.difference = here.simulated - here.mean;
  if (here.mean > 0) here.ratio = here.difference / here.mean;
  return here;
}

std::vector<double> stated_strains(const Comparison& result, const std::vector<double>& wanted) {
  const double from = result.strains.front();
  const double to = result.strains.back();
  if (wanted.empty()) {
    std::vector<double> quarters;
    for (const double share : {0.25, 0.5, 0.75, 1.0}) quarters.push_back(from + share * (to - from));
    return quarters;
  }
  // A test ends where it ends: what is nearer to an end than the grid can tell is at the end.
  const double rounding = 0.5 * (to - from) / static_cast<double>(kGridIntervals);
  for (const double strain : wanted) {
    if (strain >= from - rounding && strain <= to + rounding) continue;
    throw InputError(
        fmt::format("there is nothing to compare at a strain of {}: the curves have the strains {} in common", strain,
                    range_text(from, to)));
  }
  return wanted;
}

std::optional<double> share_in_range(const Comparison& result) {
  if (result.n_specimens < 2) return std::nullopt;
  return mean_over_grid([&](std::size_t i) {
    return result.simulated[i] >= result.lowest[i] && result.simulated[i] <= result.highest[i] ? 1.0 : 0.0;
  });
}

}  // namespace

Comparison compare(const SimulatedCurve& simulated, const MeanCurve& measured, const ComparisonSettings& settings) {
  Comparison result;
  result.n_specimens = measured.n_curves;
  result.offset = settings.finds_offset ? best_offset(simulated, measured) : settings.offset;
  const StrainRange range = common_range(simulated, measured, result.offset);
  check_in_common(simulated, measured, range, result.offset);
  lay_over(simulated, measured, range, result);
  if (!(result.largest_force > 0)) {
    throw InputError(fmt::format("no measured force is above 0 {}, the strains that the curves have in common",
                                 range_text(range.from, range.to)));
  }
  result.lowest = forces_at(result.strains, result.offset, measured.strains, measured.least, 1);
  result.highest = forces_at(result.strains, result.offset, measured.strains, measured.greatest, 1);
  result.share_in_range = share_in_range(result);
  for (const double strain : stated_strains(result, settings.at)) result.at.push_back(difference_at(result, strain));
  result.simulated_fit = fit_knot(result.strains, result.simulated);
  result.measured_fit = fit_knot(result.strains, result.mean);
  const double length = range.to - range.from;
  result.simulated_work = length * mean_over_grid([&](std::size_t i) { return result.simulated[i]; });
  result.measured_work = length * mean_over_grid([&](std::size_t i) { return result.mean[i]; });
  return result;
}

}  // namespace knitmech::compare
