#include "beam/elements.h"

#include <cmath>

namespace knitmech::beam {

namespace {

/// Abaqus' default slenderness compensation factor.
constexpr double kSlendernessCompensation = 0.25;

Elements inert_elements(std::size_t n) {
  Elements elements;
  elements.axis_x.assign(n, 1.0);
  elements.axis_y.assign(n, 0.0);
  elements.axis_z.assign(n, 0.0);
  elements.inverse_length.assign(n, 1.0);
  for (auto* stiffness : {&elements.axial, &elements.stiffest, &elements.shear, &elements.torsion, &elements.bending,
                          &elements.fold, &elements.mass, &elements.viscosity}) {
    stiffness->assign(n, 0.0);
  }
  return elements;
}

/// k = EA L0 / 8 of a yarn that bends more easily than a solid one of its diameter and EA; see FoldLimit.
double fold_stiffness(const yarn::Section& section, double length) {
  constexpr double kSoft = 0.99;  // of the solid yarn's EI, for rounding
  const double solid = section.axial_stiffness * section.diameter * section.diameter / 16;
  return section.bending_stiffness < kSoft * solid ? section.axial_stiffness * length / 8 : 0;
}

/// Largest slope of the force over the strain of a section [N].
double largest_axial_stiffness(const model::Model& model, int section) {
  const auto law = model.axial_laws.find(section);
  return law == model.axial_laws.end() ? model.sections[static_cast<std::size_t>(section)].axial_stiffness
                                       : law->second.largest_slope();
}

}  // namespace

double compensated_shear_stiffness(const yarn::Section& section, double length) {
  return section.shear_stiffness / (1 + kSlendernessCompensation * length * length * section.slenderness() / 12);
}

Elements make_elements(const model::Model& model, double mass_scaling, double bulk_viscosity) {
  Elements elements = inert_elements(model.nodes.size());
  for (const model::ModelYarn& yarn : model.yarns) {
    const auto first = static_cast<std::size_t>(yarn.first_node);
    const auto last = first + static_cast<std::size_t>(yarn.n_nodes) - 1;
    for (std::size_t i = first; i < last; ++i) {
      const yarn::Section& section = model.section_of(i);
      const Eigen::Vector3d chord = model.nodes[i + 1] - model.nodes[i];
      const double length = chord.norm();
      elements.axis_x[i] = chord.x() / length;
      elements.axis_y[i] = chord.y() / length;
      elements.axis_z[i] = chord.z() / length;
      elements.inverse_length[i] = 1 / length;
      elements.axial[i] = section.axial_stiffness;
      elements.stiffest[i] = largest_axial_stiffness(model, model.element_section[i]);
      elements.shear[i] = compensated_shear_stiffness(section, length);
      elements.torsion[i] = section.torsional_stiffness;
      elements.bending[i] = section.bending_stiffness;
      elements.fold[i] = fold_stiffness(section, length);
      elements.mass[i] = section.mass_per_length * length;
      elements.viscosity[i] = bulk_viscosity * std::sqrt(elements.stiffest[i] * section.mass_per_length * mass_scaling);
    }
  }
  return elements;
}

}  // namespace knitmech::beam
