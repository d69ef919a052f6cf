#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace knitmech::base {

/// Slope of the least-squares line with intercept through points (x, y): the sum of (x - mean x) y over that of
/// (x - mean x)^2. Empty if there are not two different x. @param y as many as x
[[nodiscard]] inline std::optional<double> line_slope(std::span<const double> x, std::span<const double> y) {
  double mean = 0;
  for (const double each : x) mean += each / static_cast<double>(x.size());
  double xx = 0;
  double xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean) * (x[i] - mean);
    xy += (x[i] - mean) * y[i];
  }
  return xx > 0 ? std::optional(xy / xx) : std::nullopt;
}

}  // namespace knitmech::base
