#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "exchange/abaqus_deck.h"
#include "exchange/abaqus_lines.h"

/// How each keyword is read, for abaqus_reader.cpp alone.
namespace knitmech::exchange::deck {

/// What is read so far, and where in the deck we are.
struct Reading {
  AbaqusDeck deck;
  std::string source;
  AbaqusDeck::Step* step = nullptr;  ///< the step we are in
  std::string material;              ///< the material *DENSITY and *ELASTIC belong to
  std::string interaction;           ///< the interaction *FRICTION belongs to
  const KeywordBlock* output = nullptr;

  [[noreturn]] void fail(int line, const std::string& message) const { fail_at(source, line, message); }
  /// Entry i of a line as a real number; 0 if it is empty.
  [[nodiscard]] double real(const DataLine& data, std::size_t i) const {
    return real_number(source, data.line, data.entry(i));
  }
  /// Entry i of a line as an integer.
  [[nodiscard]] int whole(const DataLine& data, std::size_t i) const {
    return integer(source, data.line, data.entry(i));
  }
  /// All entries of a line as real numbers; a comma at its end adds none.
  [[nodiscard]] std::vector<double> reals(const DataLine& data) const;
  /// Value of an option that has to be there.
  [[nodiscard]] std::string required(const KeywordBlock& block, const char* option) const;
  /// Data line i of a keyword that has to have it.
  [[nodiscard]] const DataLine& data_line(const KeywordBlock& block, std::size_t i) const;
};

// Nodes, elements and sets: abaqus_read_mesh.cpp.
void read_nodes(Reading& reading, const KeywordBlock& block);
void read_elements(Reading& reading, const KeywordBlock& block);
void read_node_set(Reading& reading, const KeywordBlock& block);
void read_element_set(Reading& reading, const KeywordBlock& block);

// Sections, materials and contact: abaqus_read_properties.cpp.
void read_beam_section(Reading& reading, const KeywordBlock& block);
void read_general_beam_section(Reading& reading, const KeywordBlock& block);
void read_section_behaviour(Reading& reading, const KeywordBlock& block);
void read_transverse_shear(Reading& reading, const KeywordBlock& block);
void read_material(Reading& reading, const KeywordBlock& block);
void read_density(Reading& reading, const KeywordBlock& block);
void read_elastic(Reading& reading, const KeywordBlock& block);
void read_surface(Reading& reading, const KeywordBlock& block);
void read_interaction(Reading& reading, const KeywordBlock& block);
void read_friction(Reading& reading, const KeywordBlock& block);
void read_surface_behavior(Reading& reading, const KeywordBlock& block);
void read_contact(Reading& reading, const KeywordBlock& block);
void read_contact_inclusions(Reading& reading, const KeywordBlock& block);
void read_contact_properties(Reading& reading, const KeywordBlock& block);
void read_surface_property(Reading& reading, const KeywordBlock& block);

// Ties: abaqus_read_equations.cpp.
void read_equations(Reading& reading, const KeywordBlock& block);

// Amplitudes, boundaries, the step and its output: abaqus_read_step.cpp.
void read_amplitude(Reading& reading, const KeywordBlock& block);
void read_boundary(Reading& reading, const KeywordBlock& block);
void read_step(Reading& reading, const KeywordBlock& block);
void read_end_step(Reading& reading, const KeywordBlock& block);
void read_dynamic(Reading& reading, const KeywordBlock& block);
void read_bulk_viscosity(Reading& reading, const KeywordBlock& block);
void read_mass_scaling(Reading& reading, const KeywordBlock& block);
void read_output(Reading& reading, const KeywordBlock& block);
void read_output_request(Reading& reading, const KeywordBlock& block);

}  // namespace knitmech::exchange::deck
