#include "yarn/fineness.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "base/quantity.h"

namespace knitmech::yarn {
namespace {

/// By how much three given values may contradict each other [-]: they are rounded as data sheets round them.
constexpr double kContradiction = 0.01;

void check_positive(const char* name, const std::optional<double>& value) {
  if (value && !(*value > 0 && std::isfinite(*value))) {
    throw InputError(fmt::format("the yarn's {} must be more than 0", name));
  }
}

double area(double diameter) {
  return std::numbers::pi / 4 * diameter * diameter;
}

}  // namespace

Fineness completed(Fineness fineness) {
  auto& [diameter, linear_density, density] = fineness;
  check_positive("diameter", diameter);
  check_positive("linear density", linear_density);
  check_positive("density", density);
  if (diameter && density) {
    const double implied = *density * area(*diameter);
    if (linear_density && std::abs(*linear_density - implied) > kContradiction * implied) {
      throw InputError(
          fmt::format("the yarn's diameter and density make {:.4g} tex, but its linear density is given as {}; give "
                      "two of the three",
                      implied * 1e12, base::format_quantity(*linear_density, base::Dimension::linear_density)));
    }
    if (!linear_density) linear_density = implied;
  } else if (diameter && linear_density) {
    density = *linear_density / area(*diameter);
  } else if (density && linear_density) {
    diameter = std::sqrt(*linear_density / *density * 4 / std::numbers::pi);
  }
  return fineness;
}

}  // namespace knitmech::yarn
