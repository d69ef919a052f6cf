#include "solve/contact_frequency.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solve/constants.h"

namespace knitmech::solve {

namespace {

/// Positive numbers d, as inertias 1 / d^2 of all displacements and rotations.
struct Trial {
  std::vector<double> mass, rotary;
};

/// inverse(M) |K| d of all displacements, then of all rotations.
std::vector<double> image(const ScaledRows& rows, const Trial& d, const beam::NodalInertia& inertia,
                          const SelectiveMass& masses) {
  std::vector<double> image = rows(d.mass, d.rotary);
  const std::size_t n = d.mass.size();
  for (std::size_t i = 0; i < n; ++i) {
    image[i] *= std::sqrt(d.mass[i]);
    image[n + i] *= std::sqrt(d.rotary[i]) / inertia.rotary[i];
  }
  masses.accelerate_free(image.data());
  return image;
}

double bound(const std::vector<double>& image, const Trial& d) {
  double highest = 0;
  const std::size_t n = d.mass.size();
  for (std::size_t i = 0; i < n; ++i) {
    highest = std::max({highest, image[i] * std::sqrt(d.mass[i]), image[n + i] * std::sqrt(d.rotary[i])});
  }
  return highest;
}

/// 1 / d^2 of values, of which none counts for less than a share of the largest.
std::vector<double> as_inertia(std::vector<double>::const_iterator begin, std::vector<double>::const_iterator end) {
  const double least = std::max(kLeastTrial * *std::max_element(begin, end), std::numeric_limits<double>::min());
  std::vector<double> inertia;
  for (auto value = begin; value != end; ++value) inertia.push_back(1 / std::pow(std::max(*value, least), 2));
  return inertia;
}

}  // namespace

double highest_frequency_squared(const ScaledRows& rows, const beam::NodalInertia& inertia,
                                 const SelectiveMass& masses) {
  if (masses.is_lumped()) {
    const std::vector<double> sums = rows(inertia.mass, inertia.rotary);
    return *std::max_element(sums.begin(), sums.end());
  }
  const Trial even{masses.felt(), inertia.rotary};
  const std::vector<double> first = image(rows, even, inertia, masses);
  const double first_bound = bound(first, even);
  if (first_bound == 0) return 0;
  const auto middle = first.begin() + static_cast<std::ptrdiff_t>(even.mass.size());
  const Trial better{as_inertia(first.begin(), middle), as_inertia(middle, first.end())};
  return std::min(first_bound, bound(image(rows, better, inertia, masses), better));
}

}  // namespace knitmech::solve
