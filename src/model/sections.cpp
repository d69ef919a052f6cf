#include "model/sections.h"

#include <numbers>
#include <vector>

#include "base/errors.h"
#include "model/case_rules.h"
#include "model/constants.h"
#include "yarn/monofilament.h"
#include "yarn/multifilament.h"

namespace knitmech::model {
namespace {

yarn::Monofilament material_of(const YarnStiffness& yarn, double diameter, double density) {
  return {.diameter = diameter,
          .youngs_modulus = *yarn.youngs_modulus,
          .poissons_ratio = yarn.poissons_ratio.value_or(0),
          .density = density,
          .shear_modulus = yarn.shear_modulus};
}

/// The section of a yarn whose stiffness is complete, in just one of the three ways.
yarn::Section section_from(const YarnStiffness& yarn, double diameter, double density) {
  if (yarn.axial_stiffness) {
    return yarn::section_of(yarn::MeasuredYarn{.diameter = diameter,
                                               .density = density,
                                               .axial_stiffness = *yarn.axial_stiffness,
                                               .bending_stiffness = *yarn.bending_stiffness,
                                               .torsional_stiffness = *yarn.torsional_stiffness});
  }
  if (!yarn.filaments) return yarn::section_of(material_of(yarn, diameter, density));
  return yarn::section_of(yarn::Multifilament{.filaments = *yarn.filaments,
                                              .filament = material_of(yarn, *yarn.filament_diameter, density),
                                              .diameter = diameter,
                                              .twist = *yarn.twist});
}

}  // namespace

std::optional<yarn::AxialLaw> axial_law_of(const Case& input) {
  if (input.yarn.curve_strains.empty()) return std::nullopt;
  std::vector<yarn::AxialPoint> points;
  for (std::size_t i = 0; i < input.yarn.curve_strains.size(); ++i) {
    points.push_back({input.yarn.curve_strains[i], input.yarn.curve_forces.at(i)});
  }
  return yarn::AxialLaw(points);
}

yarn::Section section_of(const Case& input) {
  if (const auto broken = broken_rule(input)) throw InputError(broken->key + " " + broken->complaint + ".");
  const YarnStiffness& given = input.yarn;
  YarnStiffness stiffness = given;
  const double diameter = input.yarn.diameter;
  if (const auto law = axial_law_of(input)) {
    const double area = std::numbers::pi * diameter * diameter / 4;
    const bool outright = stiffness.bending_stiffness.has_value();
    (outright ? stiffness.axial_stiffness : stiffness.youngs_modulus) = law->slope_at_zero() / (outright ? 1 : area);
  }
  return section_from(stiffness, diameter, input.yarn.density);
}

yarn::Section edge_section_of(const Case& input) {
  const yarn::Section yarn = section_of(input);
  const YarnStiffness& given = input.edge_yarn;
  YarnStiffness stiffness = given;
  if (!stiffness.youngs_modulus) {
    const double bending = stiffness.bending_stiffness.value_or(kEdgeBendingStiffness);
    stiffness.axial_stiffness = stiffness.axial_stiffness.value_or(yarn.axial_stiffness);
    stiffness.bending_stiffness = bending;
    stiffness.torsional_stiffness =
        stiffness.torsional_stiffness.value_or(bending * yarn.torsional_stiffness / yarn.bending_stiffness);
  }
  return section_from(stiffness, input.edge_yarn.diameter.value_or(yarn.diameter),
                      input.edge_yarn.density.value_or(input.yarn.density));
}

}  // namespace knitmech::model
