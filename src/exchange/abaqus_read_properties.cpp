#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

#include "exchange/abaqus_reading.h"

namespace knitmech::exchange::deck {

namespace {

void read_first_axis(const Reading& reading, const KeywordBlock& block, AbaqusDeck::Section& section) {
  if (block.data.size() < 2 || block.data[1].is_blank()) return;
  const DataLine& data = block.data[1];
  section.first_axis = {reading.real(data, 0), reading.real(data, 1), reading.real(data, 2)};
  if (section.first_axis.norm() == 0) reading.fail(data.line, "the direction of the first axis is zero");
}

AbaqusDeck::Material& current_material(Reading& reading, const KeywordBlock& block) {
  if (reading.material.empty()) reading.fail(block.line, fmt::format("{} outside a *MATERIAL", block.as_written));
  return reading.deck.materials.at(reading.material);
}

AbaqusDeck::Interaction& current_interaction(Reading& reading, const KeywordBlock& block) {
  if (reading.interaction.empty()) {
    reading.fail(block.line, fmt::format("{} outside a *SURFACE INTERACTION", block.as_written));
  }
  return reading.deck.interactions.at(reading.interaction);
}

AbaqusDeck::Contact& current_contact(Reading& reading, const KeywordBlock& block) {
  if (!reading.deck.contact) reading.fail(block.line, fmt::format("{} without *CONTACT before it", block.as_written));
  return *reading.deck.contact;
}

}  // namespace

void read_beam_section(Reading& reading, const KeywordBlock& block) {
  AbaqusDeck::Section section;
  section.line = block.line;
  section.element_set = reading.required(block, "ELSET");
  section.shape = reading.required(block, "SECTION");
  section.material = reading.required(block, "MATERIAL");
  section.rotary_inertia = block.option("ROTARYINERTIA", "EXACT");
  section.dimensions = reading.reals(reading.data_line(block, 0));
  read_first_axis(reading, block, section);
  if (section.shape == "CIRC" && section.dimensions.front() <= 0) {
    reading.fail(block.data.front().line, "the radius of a CIRC section must be positive");
  }
  reading.deck.sections.push_back(std::move(section));
}

void read_general_beam_section(Reading& reading, const KeywordBlock& block) {
  AbaqusDeck::Section section;
  section.kind = AbaqusDeck::SectionKind::general_beam;
  section.line = block.line;
  section.element_set = reading.required(block, "ELSET");
  section.shape = block.option("SECTION", "GENERAL");
  section.density = real_number(reading.source, block.line, block.option("DENSITY"));
  section.rotary_inertia = block.option("ROTARYINERTIA", "EXACT");
  section.dimensions = reading.reals(reading.data_line(block, 0));
  read_first_axis(reading, block, section);
  const bool is_nonlinear = section.shape == "NONLINEAR GENERAL";
  if (!is_nonlinear) section.moduli = reading.reals(reading.data_line(block, 2));
  if ((section.shape == "GENERAL" || is_nonlinear) && section.dimensions.size() < 5) {
    reading.fail(block.data.front().line, fmt::format("a {} section needs A, I11, I12, I22, J", section.shape));
  }
  if (!is_nonlinear && section.moduli.size() < 2) reading.fail(block.data[2].line, "a general section needs E and G");
  reading.deck.sections.push_back(std::move(section));
}

/// *AXIAL, *M1, *M2 and *TORQUE.
void read_section_behaviour(Reading& reading, const KeywordBlock& block) {
  if (reading.deck.sections.empty() || reading.deck.sections.back().shape != "NONLINEAR GENERAL") {
    reading.fail(block.line, fmt::format("{} without a NONLINEAR GENERAL section before it", block.as_written));
  }
  AbaqusDeck::Section& section = reading.deck.sections.back();
  static const std::map<std::string, double AbaqusDeck::Section::*> kStiffnesses = {
      {"AXIAL", &AbaqusDeck::Section::axial},
      {"M1", &AbaqusDeck::Section::bending_1},
      {"M2", &AbaqusDeck::Section::bending_2},
      {"TORQUE", &AbaqusDeck::Section::torsion}};
  if (block.has("LINEAR")) {
    section.*kStiffnesses.at(block.keyword) = reading.real(reading.data_line(block, 0), 0);
    return;
  }
  if (block.keyword != "AXIAL" || !block.has("ELASTIC")) {
    reading.fail(block.line, fmt::format("{} must be LINEAR, or ELASTIC if it is *AXIAL", block.as_written));
  }
  for (const DataLine& data : block.data) {
    if (data.is_blank()) continue;
    const double strain = reading.real(data, 1);
    if (!section.axial_curve.empty() && strain <= section.axial_curve.back().first) {
      reading.fail(data.line, "the strains of *AXIAL must ascend");
    }
    section.axial_curve.emplace_back(strain, reading.real(data, 0));
  }
}

void read_transverse_shear(Reading& reading, const KeywordBlock& block) {
  if (reading.deck.sections.empty())
    reading.fail(block.line, fmt::format("{} without a section before it", block.as_written));
  reading.deck.sections.back().transverse_shear = reading.reals(reading.data_line(block, 0));
}

void read_material(Reading& reading, const KeywordBlock& block) {
  reading.material = reading.required(block, "NAME");
  AbaqusDeck::Material material;
  material.line = block.line;
  if (!reading.deck.materials.emplace(reading.material, material).second) {
    reading.fail(block.line, fmt::format("the material {} is defined a second time", reading.material));
  }
}

void read_density(Reading& reading, const KeywordBlock& block) {
  current_material(reading, block).density = reading.real(reading.data_line(block, 0), 0);
}

void read_elastic(Reading& reading, const KeywordBlock& block) {
  AbaqusDeck::Material& material = current_material(reading, block);
  const DataLine& data = reading.data_line(block, 0);
  material.youngs_modulus = reading.real(data, 0);
  material.poissons_ratio = reading.real(data, 1);
}

void read_surface(Reading& reading, const KeywordBlock& block) {
  AbaqusDeck::Surface surface;
  surface.line = block.line;
  surface.type = block.option("TYPE", "ELEMENT");
  for (const DataLine& data : block.data) {
    if (!data.is_blank()) surface.sets.push_back(data.entry(0));
  }
  reading.deck.surfaces[reading.required(block, "NAME")] = std::move(surface);
}

void read_interaction(Reading& reading, const KeywordBlock& block) {
  reading.interaction = reading.required(block, "NAME");
  reading.deck.interactions[reading.interaction].line = block.line;
}

void read_friction(Reading& reading, const KeywordBlock& block) {
  const double friction = reading.real(reading.data_line(block, 0), 0);
  if (friction < 0) reading.fail(block.data.front().line, "a friction coefficient must not be negative");
  current_interaction(reading, block).friction = friction;
}

void read_surface_behavior(Reading& reading, const KeywordBlock& block) {
  current_interaction(reading, block).pressure_overclosure = block.option("PRESSURE-OVERCLOSURE", "HARD");
}

void read_contact(Reading& reading, const KeywordBlock& block) {
  AbaqusDeck::Contact contact;
  contact.line = block.line;
  reading.deck.contact = std::move(contact);
}

void read_contact_inclusions(Reading& reading, const KeywordBlock& block) {
  AbaqusDeck::Contact& contact = current_contact(reading, block);
  contact.all_exterior = block.has("ALLEXTERIOR");
  for (const DataLine& data : block.data) {
    if (!data.is_blank()) contact.inclusions.emplace_back(data.entry(0), data.entry(1));
  }
}

void read_contact_properties(Reading& reading, const KeywordBlock& block) {
  for (const DataLine& data : block.data) {
    if (data.is_blank()) continue;
    current_contact(reading, block).properties.push_back({data.entry(0), data.entry(1), data.entry(2)});
  }
}

void read_surface_property(Reading& reading, const KeywordBlock& block) {
  if (reading.required(block, "PROPERTY") != "THICKNESS") {
    reading.deck.unread.push_back({block.as_written, block.line});
    return;
  }
  for (const DataLine& data : block.data) {
    if (!data.is_blank()) current_contact(reading, block).thickness[data.entry(0)] = reading.real(data, 1);
  }
}

}  // namespace knitmech::exchange::deck
