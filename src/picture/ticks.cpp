#include "picture/ticks.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace knitmech::picture {
namespace {

/// The multiple of a power of ten among 1, 2, 5 that is nearest above the wanted step.
double nice_step(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (wanted <= factor * power * (1 + 1e-9)) {
      return factor * power;
    }
  }
  return 10 * power;
}

int decimals_of(double step) {
  return std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
}

std::string label_of(double value, double step, double largest) {
  if (largest >= 1e6 || step < 1e-5) {
    return fmt::format("{:.4g}", value);
  }
  return fmt::format("{:.{}f}", value, decimals_of(step));
}

}  // namespace

Ticks nice_ticks(double lowest, double highest, int intervals) {
  if (!std::isfinite(lowest) || !std::isfinite(highest)) {
    lowest = 0;
    highest = 1;
  }
  // A range narrower than this share of its values cannot be told apart by the labels.
  const double least_width = 1e-9 * std::max(std::abs(lowest), std::abs(highest));
  if (highest - lowest <= least_width) {
    const double half = lowest == 0 ? 0.5 : 0.5 * std::abs(lowest);
    lowest -= half;
    highest += half;
  }
  const double step = nice_step((highest - lowest) / std::max(1, intervals));
  const auto begin = static_cast<long long>(std::floor(lowest / step + 1e-9));
  const auto end = static_cast<long long>(std::ceil(highest / step - 1e-9));
  Ticks ticks;
  for (long long i = begin; i <= end; ++i) {
    const double value = static_cast<double>(i) * step;
    ticks.values.push_back(value);
    ticks.labels.push_back(label_of(value, step, std::max(std::abs(lowest), std::abs(highest))));
  }
  return ticks;
}

Ticks nice_log_ticks(double lowest, double highest) {
  if (!std::isfinite(lowest) || !std::isfinite(highest)) {
    lowest = 0;
    highest = 1;
  }
  constexpr double kRounding = 1e-9;
  constexpr std::array<double, 3> kFactors{1, 2, 5};
  const std::size_t n_factors = highest - lowest < 3 ? kFactors.size() : 1;
  Ticks ticks;
  for (double power = std::floor(lowest + kRounding);; ++power) {
    for (std::size_t i = 0; i < n_factors; ++i) {
      const double value = power + std::log10(kFactors[i]);
      if (value <= lowest + kRounding) ticks = {};
      ticks.values.push_back(value);
      ticks.labels.push_back(fmt::format("{:.{}f}", std::pow(10.0, value), std::max(0, static_cast<int>(-power))));
      if (value >= highest - kRounding && ticks.values.size() > 1) return ticks;
    }
  }
}

double round_number_below(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit) + 1e-9));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= limit * (1 + 1e-9)) {
      return factor * power;
    }
  }
  return power;
}

}  // namespace knitmech::picture
