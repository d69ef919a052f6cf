#include <fmt/format.h>

#include <array>
#include <map>
#include <ostream>
#include <set>
#include <string>

#include "exchange/abaqus_number.h"
#include "exchange/abaqus_parts.h"
#include "exchange/abaqus_section.h"
#include "exchange/constants.h"

namespace knitmech::exchange::deck {

namespace {

constexpr const char* kSurface = "YARN_SURFACE";
constexpr const char* kInteraction = "YARN_ON_YARN";

std::string section_surface(int section) {
  return fmt::format("SECTION_{}_SURFACE", section + 1);
}
std::string material_name(int section) {
  return fmt::format("YARN_{}", section + 1);
}

void write_circle(std::ostream& out, const SectionGroup& group, const AbaqusSection& section) {
  line(out, "*BEAM SECTION, ELSET={}, MATERIAL={}, SECTION=CIRC, ROTARY INERTIA=ISOTROPIC", group.set,
       material_name(group.section));
  line(out, "{}", abaqus_number(section.radius));
}

void write_general(std::ostream& out, const SectionGroup& group, const AbaqusSection& section, const char* kind) {
  line(out, "*BEAM GENERAL SECTION, ELSET={}, SECTION={}, DENSITY={}, ROTARY INERTIA=ISOTROPIC", group.set, kind,
       abaqus_number(section.density));
  line(out, "{}, {}, 0., {}, {}", abaqus_number(section.area), abaqus_number(section.inertia),
       abaqus_number(section.inertia), abaqus_number(section.torsion_constant));
}

/// Force and strain of a measured curve, as straight pieces, far beyond the strains of any test on both sides: Abaqus
/// does not go on beyond the last line.
void write_curve(std::ostream& out, const yarn::AxialLaw& law) {
  const auto write = [&](double strain) {
    line(out, "{}, {}", abaqus_number(law.force(strain)), abaqus_number(strain));
  };
  write(-kCurveReach);
  const std::vector<double> strains = law.strains();
  for (std::size_t i = 0; i + 1 < strains.size(); ++i) {
    for (int k = 0; k < kCurvePieces; ++k) write(strains[i] + (strains[i + 1] - strains[i]) * k / kCurvePieces);
  }
  write(law.last_strain());
  write(law.last_strain() + kCurveReach);
}

/// What follows the first axis of a section with a measured curve.
void write_curve_behaviour(std::ostream& out, const yarn::Section& section, const yarn::AxialLaw& law) {
  out << "*AXIAL, ELASTIC\n";
  write_curve(out, law);
  for (const char* bending : {"*M1, LINEAR", "*M2, LINEAR"}) {
    line(out, "{}\n{},", bending, abaqus_number(section.bending_stiffness));
  }
  line(out, "*TORQUE, LINEAR\n{},", abaqus_number(section.torsional_stiffness));
}

/// Whether a section is written as that of a solid circle of one material.
bool is_circle(const model::Model& model, int section) {
  return !model.axial_laws.contains(section) &&
         abaqus_section(model.sections[static_cast<std::size_t>(section)]).circle;
}

void write_section(std::ostream& out, const model::Model& model, const SectionGroup& group) {
  static constexpr std::array<const char*, 3> kAxes = {"1., 0., 0.", "0., 1., 0.", "0., 0., 1."};
  const yarn::Section& of_yarn = model.sections[static_cast<std::size_t>(group.section)];
  const AbaqusSection section = abaqus_section(of_yarn);
  const auto law = model.axial_laws.find(group.section);
  if (is_circle(model, group.section)) {
    write_circle(out, group, section);
  } else {
    write_general(out, group, section, law == model.axial_laws.end() ? "GENERAL" : "NONLINEAR GENERAL");
  }
  line(out, "{}", kAxes[static_cast<std::size_t>(group.axis)]);
  if (law != model.axial_laws.end()) {
    write_curve_behaviour(out, of_yarn, law->second);
  } else if (!section.circle) {
    line(out, "{}, {}", abaqus_number(section.youngs_modulus), abaqus_number(section.shear_modulus));
  }
  const std::string shear = abaqus_number(section.shear_stiffness);
  out << "*TRANSVERSE SHEAR STIFFNESS\n";
  line(out, "{}, {}, {}", shear, shear, abaqus_number(section.slenderness_compensation));
}

void write_surface(std::ostream& out, const std::string& name, const std::string& set) {
  line(out, "*SURFACE, NAME={}, TYPE=ELEMENT", name);
  line(out, "{},", set);
}

std::string pair_interaction(const model::PairFriction& pair) {
  return fmt::format("SECTION_{}_ON_SECTION_{}", pair.first_section + 1, pair.second_section + 1);
}

void write_interaction(std::ostream& out, const std::string& name, double friction) {
  line(out, "*SURFACE INTERACTION, NAME={}", name);
  out << "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD\n*FRICTION\n";
  line(out, "{},", abaqus_number(friction));
}

/// A general section has no outline; its contact diameter is given as a surface thickness.
void write_contact_diameters(std::ostream& out, const std::map<int, double>& diameters) {
  if (diameters.empty()) return;
  out << "*SURFACE PROPERTY ASSIGNMENT, PROPERTY=THICKNESS\n";
  for (const auto& [section, diameter] : diameters) {
    line(out, "{}, {}", section_surface(section), abaqus_number(diameter));
  }
}

}  // namespace

std::string section_set(int section) {
  return fmt::format("SECTION_{}", section + 1);
}

std::vector<SectionGroup> section_groups(const model::Model& model) {
  static constexpr std::array<const char*, 3> kAxisNames = {"X", "Y", "Z"};
  std::map<std::pair<int, int>, std::vector<int>> elements;
  int number = 0;
  for (const model::ModelYarn& yarn : model.yarns) {
    for (int i = yarn.first_node; i < yarn.first_node + yarn.n_nodes - 1; ++i) {
      const auto node = static_cast<std::size_t>(i);
      elements[{model.element_section[node], first_axis(model.nodes[node + 1] - model.nodes[node])}].push_back(
          ++number);
    }
  }
  std::map<int, int> axes_of_section;
  for (const auto& [key, numbers] : elements) ++axes_of_section[key.first];
  std::vector<SectionGroup> groups;
  for (auto& [key, numbers] : elements) {
    const auto [section, axis] = key;
    std::string set = section_set(section);
    if (axes_of_section[section] > 1) set += fmt::format("_AXIS_{}", kAxisNames[static_cast<std::size_t>(axis)]);
    groups.push_back({std::move(set), section, axis, std::move(numbers)});
  }
  return groups;
}

void write_sections(std::ostream& out, const model::Model& model, const std::vector<SectionGroup>& groups) {
  caption(out, "SECTIONS: radius, not diameter; or A, I11, I12, I22, J and E, G; then the direction of the first axis");
  for (const SectionGroup& group : groups) {
    write_section(out, model, group);
  }
  for (const auto& [section, strength] : model.strengths) {
    line(out, "** In KnitMech the yarn of {} breaks at {} N; here it does not.", section_set(section),
         abaqus_number(strength));
  }
}

void write_materials(std::ostream& out, const model::Model& model) {
  caption(out, "MATERIALS (a general section carries its own and needs none here)");
  for (int i = 0; i < static_cast<int>(model.sections.size()); ++i) {
    if (!is_circle(model, i)) continue;
    const AbaqusSection section = abaqus_section(model.sections[static_cast<std::size_t>(i)]);
    line(out, "*MATERIAL, NAME={}", material_name(i));
    out << "*DENSITY\n";
    line(out, "{},", abaqus_number(section.density));
    out << "*ELASTIC\n";
    line(out, "{}, {}", abaqus_number(section.youngs_modulus), abaqus_number(section.poissons_ratio));
  }
}

void write_contact(std::ostream& out, const model::Model& model, const std::vector<SectionGroup>& groups) {
  caption(out, "CONTACT: every yarn with every yarn and with itself");
  std::map<int, double> diameters;
  for (const SectionGroup& group : groups) {
    const yarn::Section& section = model.sections[static_cast<std::size_t>(group.section)];
    if (!is_circle(model, group.section)) diameters[group.section] = section.diameter;
  }
  std::set<int> with_surface;
  for (const auto& [section, diameter] : diameters) with_surface.insert(section);
  for (const model::PairFriction& pair : model.pair_friction) {
    with_surface.insert({pair.first_section, pair.second_section});
  }
  write_surface(out, kSurface, kAllElements);
  for (const int section : with_surface) write_surface(out, section_surface(section), section_set(section));
  write_interaction(out, kInteraction, model.friction);
  for (const model::PairFriction& pair : model.pair_friction) {
    write_interaction(out, pair_interaction(pair), pair.friction);
  }
  out << "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n";
  out << "*CONTACT PROPERTY ASSIGNMENT\n";
  line(out, "{}, {}, {}", kSurface, kSurface, kInteraction);
  for (const model::PairFriction& pair : model.pair_friction) {
    line(out, "{}, {}, {}", section_surface(pair.first_section), section_surface(pair.second_section),
         pair_interaction(pair));
  }
  write_contact_diameters(out, diameters);
}

}  // namespace knitmech::exchange::deck
