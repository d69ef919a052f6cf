#pragma once

#include <cstddef>
#include <limits>

namespace knitmech::compare {

/// Where a function is least between two ends: the best of evenly spaced places, refined between its neighbours by
/// golden sections, which finds the least value exactly where the function has one valley there.
template <class Function>
double least_of(double from, double to, std::size_t n_tried, Function&& function) {
  const double spacing = (to - from) / static_cast<double>(n_tried);
  double best = from;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= n_tried; ++i) {
    const double place = from + spacing * static_cast<double>(i);
    if (const double value = function(place); value < least) {
      least = value;
      best = place;
    }
  }
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSections = 60;  // narrow the interval to rounding
  double a = best - spacing > from ? best - spacing : from;
  double b = best + spacing < to ? best + spacing : to;
  for (int i = 0; i < kSections; ++i) {
    const double c = b - kGolden * (b - a);
    const double d = a + kGolden * (b - a);
    if (function(c) < function(d)) {
      b = d;
    } else {
      a = c;
    }
  }
  const double refined = 0.5 * (a + b);
  return function(refined) < least ? refined : best;
}

}  // namespace knitmech::compare
