#include "yarn/monofilament.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.h"

namespace knitmech::yarn {
namespace {

/// The Poisson's ratios between which an implied one is believed [-]: the range of solid polymers. A wider range
/// changes only the shear stiffness of yarns whose EI / GJ lies outside 1 to 1.5.
constexpr double kLeastImpliedPoissonsRatio = 0.0;
constexpr double kLargestImpliedPoissonsRatio = 0.5;

void check_positive(const char* key, double value, const char* unit) {
  if (value > 0 && std::isfinite(value)) return;
  throw InputError(fmt::format("{} is {} {}, but must be more than 0.", key, value, unit));
}

double circle_area(double diameter) {
  return std::numbers::pi / 4 * diameter * diameter;
}

/// The Poisson's ratio of an isotropic circle with this E / G = EI / (GJ / 2), moved into the range that is believed.
double implied_poissons_ratio(double modulus_ratio) {
  return std::clamp(modulus_ratio / 2 - 1, kLeastImpliedPoissonsRatio, kLargestImpliedPoissonsRatio);
}

struct Shear {
  double modulus = 0;  ///< G [MPa]
  double factor = 0;   ///< k [-]
};

Shear shear_of(const Monofilament& monofilament) {
  const double youngs_modulus = monofilament.youngs_modulus;
  if (monofilament.shear_modulus) {
    const double modulus = *monofilament.shear_modulus;
    check_positive("yarn.shear_modulus", modulus, "MPa");
    return {modulus, circle_shear_factor(implied_poissons_ratio(youngs_modulus / modulus))};
  }
  const double nu = monofilament.poissons_ratio;
  if (!(nu > -1 && nu <= 0.5)) {
    throw InputError(fmt::format("yarn.poissons_ratio is {}, but must be more than -1 and at most 0.5.", nu));
  }
  return {youngs_modulus / (2 * (1 + nu)), circle_shear_factor(nu)};
}

}  // namespace

double circle_shear_factor(double poissons_ratio) {
  return 6 * (1 + poissons_ratio) / (7 + 6 * poissons_ratio);
}

Section section_of(const Monofilament& monofilament) {
  check_positive("yarn.diameter", monofilament.diameter, "mm");
  check_positive("yarn.youngs_modulus", monofilament.youngs_modulus, "MPa");
  check_positive("yarn.density", monofilament.density, "t/mm^3");
  const Shear shear = shear_of(monofilament);
  const double area = circle_area(monofilament.diameter);
  const double second_moment = area * monofilament.diameter * monofilament.diameter / 16;
  return {.diameter = monofilament.diameter,
          .axial_stiffness = monofilament.youngs_modulus * area,
          .shear_stiffness = shear.factor * shear.modulus * area,
          .bending_stiffness = monofilament.youngs_modulus * second_moment,
          .torsional_stiffness = shear.modulus * 2 * second_moment,
          .mass_per_length = monofilament.density * area};
}

Section section_of(const MeasuredYarn& yarn) {
  check_positive("yarn.diameter", yarn.diameter, "mm");
  check_positive("yarn.density", yarn.density, "t/mm^3");
  check_positive("yarn.axial_stiffness", yarn.axial_stiffness, "N");
  check_positive("yarn.bending_stiffness", yarn.bending_stiffness, "N mm^2");
  check_positive("yarn.torsional_stiffness", yarn.torsional_stiffness, "N mm^2");
  const double nu = implied_poissons_ratio(2 * yarn.bending_stiffness / yarn.torsional_stiffness);
  return {.diameter = yarn.diameter,
          .axial_stiffness = yarn.axial_stiffness,
          .shear_stiffness = circle_shear_factor(nu) * yarn.axial_stiffness / (2 * (1 + nu)),
          .bending_stiffness = yarn.bending_stiffness,
          .torsional_stiffness = yarn.torsional_stiffness,
          .mass_per_length = yarn.density * circle_area(yarn.diameter)};
}

}  // namespace knitmech::yarn
