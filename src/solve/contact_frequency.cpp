#include "solve/contact_frequency.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/vectorise.h"
#include "solve/constants.h"

namespace knitmech::solve {

namespace {

KNITMECH_VECTORISE void set_inverse_roots(const double* values, double* roots, std::size_t n) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) roots[i] = 1 / std::sqrt(values[i]);
}

KNITMECH_VECTORISE void divide(double* values, const double* by, std::size_t n) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) values[i] /= by[i];
}

KNITMECH_VECTORISE double largest_ratio(const double* values, const double* to, std::size_t n) {
  double largest = 0;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = 0; i < n; ++i) largest = largest > values[i] / to[i] ? largest : values[i] / to[i];
  return largest;
}

/// Lets none of some values count for less than a share of the largest.
void lift(std::vector<double>::iterator begin, std::vector<double>::iterator end) {
  const double least = std::max(kLeastTrial * *std::max_element(begin, end), std::numeric_limits<double>::min());
  for (auto value = begin; value != end; ++value) *value = std::max(*value, least);
}

}  // namespace

double highest_frequency_squared(const contact::Springs& springs, const beam::NodalInertia& inertia,
                                 const SelectiveMass& masses) {
  const std::size_t n = inertia.mass.size();
  std::vector<double> d(2 * n);
  std::vector<double> image;
  set_inverse_roots(masses.felt().data(), d.data(), n);
  set_inverse_roots(inertia.rotary.data(), &d[n], n);
  const auto bound = [&] {
    springs.multiply(d, image);
    masses.accelerate_free(image.data());
    divide(&image[n], inertia.rotary.data(), n);
    return largest_ratio(image.data(), d.data(), 2 * n);
  };
  const double first = bound();
  if (first == 0 || masses.is_lumped()) return first;
  std::swap(d, image);
  lift(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(n));
  lift(d.begin() + static_cast<std::ptrdiff_t>(n), d.end());
  return std::min(first, bound());
}

}  // namespace knitmech::solve
