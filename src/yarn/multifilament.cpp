#include "yarn/multifilament.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "yarn/monofilament.h"

namespace knitmech::yarn {
namespace {

/// Rounding of D that does not count as too small [-]; larger than some roundings of a double, smaller than any
/// measurement tells.
constexpr double kRounding = 1e-12;

void check(const Multifilament& yarn) {
  const double filament_diameter = yarn.filament.diameter;
  if (yarn.filaments < 1) {
    throw InputError(fmt::format("yarn.filaments is {}, but must be at least 1.", yarn.filaments));
  }
  if (!(filament_diameter > 0 && std::isfinite(filament_diameter))) {
    throw InputError(fmt::format("yarn.filament_diameter is {} mm, but must be more than 0.", filament_diameter));
  }
  if (!(yarn.diameter > 0 && std::isfinite(yarn.diameter))) {
    throw InputError(fmt::format("yarn.diameter is {} mm, but must be more than 0.", yarn.diameter));
  }
  if (!(yarn.twist >= 0 && std::isfinite(yarn.twist))) {
    throw InputError(fmt::format("yarn.twist is {} turns per mm, but must be at least 0.", yarn.twist));
  }
  const double least_diameter = filament_diameter * std::sqrt(static_cast<double>(yarn.filaments));
  if (least_diameter > yarn.diameter * (1 + kRounding)) {
    throw InputError(
        fmt::format("yarn.filaments: {} filaments of {} mm do not fit into a yarn of {} mm; yarn.diameter must be at "
                    "least {:.4g} mm.",
                    yarn.filaments, filament_diameter, yarn.diameter, least_diameter));
  }
}

/// Stiffness of a turn of the helix against a load across the axis, whose part along the filament meets `along` and
/// whose part across it meets `across`.
double helix_across(double across, double along, double cosine) {
  const double sine_squared = 1 - cosine * cosine;
  return cosine / (sine_squared / (2 * along) + (1 - sine_squared / 2) / across);
}

/// atanh(x) / x with x^2 = square, continued as atan(x) / x to negative squares.
double atanh_ratio(double square) {
  const double x = std::sqrt(std::abs(square));
  if (x == 0) return 1;
  return (square > 0 ? std::atanh(x) : std::atan(x)) / x;
}

/// m(q), the mean over v from 1 to V of v^2 / (v^2 - q), for q < 1.
double mean_quotient(double q, double largest_secant) {
  const double root = (largest_secant - 1) / (largest_secant - q);
  return 1 + q / (largest_secant - q) * atanh_ratio(q * root * root);
}

/// helix_across(), averaged over the cross-section.
double mean_across(double across, double along, double largest_secant) {
  const double sum = across + along;
  return 2 / (largest_secant + 1) * 2 * across * along / sum * mean_quotient((across - along) / sum, largest_secant);
}

}  // namespace

HelicalFilament helical_filament(const Section& filament, double helix_angle) {
  const double cosine = std::cos(helix_angle);
  const double sine = std::sin(helix_angle);
  const double bending = filament.bending_stiffness;
  const double torsional = filament.torsional_stiffness;
  return {.axial_stiffness = filament.axial_stiffness * cosine * cosine * cosine,
          .shear_stiffness = helix_across(filament.shear_stiffness, filament.axial_stiffness, cosine),
          .bending_stiffness = helix_across(bending, torsional, cosine),
          .torsional_stiffness = cosine / (cosine * cosine / torsional + sine * sine / bending),
          .mass_per_length = filament.mass_per_length / cosine};
}

Section section_of(const Multifilament& yarn) {
  check(yarn);
  const Section filament = section_of(yarn.filament);
  const double outermost = std::max(0.0, (yarn.diameter - filament.diameter) / 2);
  const double secant = std::hypot(1, 2 * std::numbers::pi * outermost * yarn.twist);
  const double n = yarn.filaments;
  const double bending = filament.bending_stiffness;
  const double torsional = filament.torsional_stiffness;
  return {.diameter = yarn.diameter,
          .axial_stiffness = n * filament.axial_stiffness * 2 / (secant * (secant + 1)),
          .shear_stiffness = n * mean_across(filament.shear_stiffness, filament.axial_stiffness, secant),
          .bending_stiffness = n * mean_across(bending, torsional, secant),
          .torsional_stiffness = n * 2 / (secant + 1) * bending * mean_quotient(1 - bending / torsional, secant),
          .mass_per_length = n * filament.mass_per_length * 2 * (secant * secant + secant + 1) / (3 * (secant + 1))};
}

}  // namespace knitmech::yarn
