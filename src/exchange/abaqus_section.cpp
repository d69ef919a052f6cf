#include "exchange/abaqus_section.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "exchange/constants.h"

namespace knitmech::exchange {

namespace {

double to_12_digits(double value) {
  return std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr);
}

bool is_circle(const yarn::Section& section, double poissons_ratio) {
  const double of_circle = section.axial_stiffness * section.diameter * section.diameter / 16;
  const double bending = section.bending_stiffness;
  return std::abs(bending - of_circle) <= kCircleTolerance * bending && poissons_ratio > -1 && poissons_ratio < 0.5;
}

}  // namespace

AbaqusSection abaqus_section(const yarn::Section& section) {
  AbaqusSection result;
  const double diameter = section.diameter;
  result.radius = diameter / 2;
  result.area = std::numbers::pi * diameter * diameter / 4;
  result.youngs_modulus = section.axial_stiffness / result.area;
  result.density = section.mass_per_length / result.area;
  result.shear_stiffness = section.shear_stiffness;
  const double slenderness = section.axial_stiffness / section.bending_stiffness;  // as Abaqus takes it
  result.slenderness_compensation = to_12_digits(kSlendernessCompensation * section.slenderness() / slenderness);
  result.inertia = section.bending_stiffness / result.youngs_modulus;
  result.torsion_constant = 2 * result.inertia;
  result.shear_modulus = section.torsional_stiffness / result.torsion_constant;
  result.poissons_ratio = to_12_digits(result.youngs_modulus / (2 * result.shear_modulus) - 1);
  result.circle = is_circle(section, result.poissons_ratio);
  if (result.circle) {
    result.youngs_modulus = to_12_digits(result.youngs_modulus);
    result.density = to_12_digits(result.density);
  }
  return result;
}

int first_axis(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d cosines = direction.normalized().cwiseAbs();
  if (cosines.z() <= kLargestFirstAxisCosine) return 2;
  int axis = 0;
  cosines.minCoeff(&axis);
  return axis;
}

}  // namespace knitmech::exchange
