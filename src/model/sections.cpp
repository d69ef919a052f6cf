#include "model/sections.h"

#include "base/errors.h"
#include "model/case_rules.h"
#include "model/constants.h"
#include "yarn/monofilament.h"

namespace knitmech::model {
namespace {

/// The section of a yarn whose stiffness is complete, in just one of the three ways.
yarn::Section section_from(const YarnStiffness& stiffness, double diameter, double density) {
  if (stiffness.axial_stiffness) {
    return yarn::section_of(yarn::MeasuredYarn{.diameter = diameter,
                                               .density = density,
                                               .axial_stiffness = *stiffness.axial_stiffness,
                                               .bending_stiffness = *stiffness.bending_stiffness,
                                               .torsional_stiffness = *stiffness.torsional_stiffness});
  }
  return yarn::section_of(yarn::Monofilament{.diameter = diameter,
                                             .youngs_modulus = *stiffness.youngs_modulus,
                                             .poissons_ratio = *stiffness.poissons_ratio,
                                             .density = density});
}

void check(const Case& input) {
  if (const auto broken = broken_rule(input)) throw InputError(broken->key + " " + broken->complaint + ".");
}

}  // namespace

yarn::Section section_of(const Case& input) {
  check(input);
  return section_from(input.yarn, input.yarn.diameter, input.yarn.density);
}

yarn::Section edge_section_of(const Case& input) {
  const yarn::Section yarn = section_of(input);
  YarnStiffness stiffness = input.edge_yarn;
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
