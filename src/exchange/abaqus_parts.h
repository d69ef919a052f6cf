#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exchange/abaqus_writer.h"
#include "exchange/constants.h"

/// The parts of an Abaqus deck, for abaqus_writer.cpp alone.
namespace knitmech::exchange::deck {

inline constexpr const char* kAllElements = "YARNS";  ///< element set of all beams

/// One line of the deck, formatted.
template <typename... Values>
void line(std::ostream& out, fmt::format_string<Values...> format, Values&&... values) {
  out << fmt::format(format, std::forward<Values>(values)...) << '\n';
}

/// A comment between two groups of keywords.
inline void caption(std::ostream& out, std::string_view text) {
  out << "**\n** " << text << "\n**\n";
}

/// Data lines of a set: at most 16 entries each.
template <typename Entry>
void write_entries(std::ostream& out, const std::vector<Entry>& entries) {
  for (std::size_t i = 0; i < entries.size(); i += kAbaqusSetEntries) {
    const auto last = std::min(entries.size(), i + kAbaqusSetEntries);
    line(out, "{}",
         fmt::join(entries.begin() + static_cast<std::ptrdiff_t>(i),
                   entries.begin() + static_cast<std::ptrdiff_t>(last), ", "));
  }
}

/// *HEADING with the title and the units.
void write_heading(std::ostream& out, const model::Model& model);

/// A data line of *NODE.
void write_node(std::ostream& out, int number, const Eigen::Vector3d& point);

/// An element set with elements of one section and one first axis: what one section keyword of Abaqus covers.
struct SectionGroup {
  std::string set;
  int section = 0;            ///< index into Model::sections
  int axis = 2;               ///< first axis of the section: 0 x, 1 y, 2 z
  std::vector<int> elements;  ///< numbers in the deck
};

/// The element set of all elements of a section.
[[nodiscard]] std::string section_set(int section);

/// Elements by section and first axis. A section whose elements share one axis is one group with the set section_set().
[[nodiscard]] std::vector<SectionGroup> section_groups(const model::Model& model);

void write_sections(std::ostream& out, const model::Model& model, const std::vector<SectionGroup>& groups);
void write_materials(std::ostream& out, const model::Model& model);
/// Model::ties as linear equations between the displacements of nodes.
void write_ties(std::ostream& out, const model::Model& model);
void write_contact(std::ostream& out, const model::Model& model, const std::vector<SectionGroup>& groups);

/// The grips and their velocity: model data.
void write_grips(std::ostream& out, const model::TensileTest& test);
/// The step with its output.
void write_step(std::ostream& out, const model::TensileTest& test, const AbaqusOptions& options);

}  // namespace knitmech::exchange::deck
