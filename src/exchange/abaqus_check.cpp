#include <fmt/format.h>

#include <map>
#include <set>
#include <string>

#include "base/text.h"
#include "exchange/abaqus_lines.h"
#include "exchange/abaqus_reader.h"

namespace knitmech::exchange {

namespace {

template <typename Map>
void require(const Map& known, const std::string& name, const char* what, const std::string& source, int line) {
  if (!known.contains(name)) fail_at(source, line, fmt::format("{} {} does not exist", what, base::in_quotes(name)));
}

void check_elements(const AbaqusDeck& deck, const std::string& source) {
  for (const auto& [number, element] : deck.elements) {
    for (const int node : element.nodes) {
      if (deck.nodes.contains(node)) continue;
      fail_at(source, element.line, fmt::format("element {} has the node {}, which does not exist", number, node));
    }
  }
}

template <typename Members>
void check_sets(const std::map<std::string, AbaqusDeck::Set>& sets, const Members& known, const char* what,
                const std::string& source) {
  for (const auto& [name, set] : sets) {
    for (const int number : set.members) {
      if (known.contains(number)) continue;
      fail_at(source, set.line, fmt::format("the set {} has the {} {}, which does not exist", name, what, number));
    }
  }
}

void check_sections(const AbaqusDeck& deck, const std::string& source) {
  std::set<int> with_section;
  for (const AbaqusDeck::Section& section : deck.sections) {
    require(deck.element_sets, section.element_set, "the element set", source, section.line);
    if (section.kind == AbaqusDeck::SectionKind::beam) {
      require(deck.materials, section.material, "the material", source, section.line);
    }
    for (const int element : deck.element_sets.at(section.element_set).members) {
      if (with_section.insert(element).second) continue;
      fail_at(source, section.line, fmt::format("element {} gets a second section", element));
    }
  }
  for (const auto& [number, element] : deck.elements) {
    if (!with_section.contains(number)) fail_at(source, element.line, fmt::format("element {} has no section", number));
  }
}

/// \param nodes a node set, or the number of a node
void require_nodes(const AbaqusDeck& deck, const std::string& nodes, const std::string& source, int line) {
  if (!looks_like_number(nodes)) {
    require(deck.node_sets, nodes, "the node set", source, line);
  } else if (!deck.nodes.contains(integer(source, line, nodes))) {
    fail_at(source, line, fmt::format("the node {} does not exist", nodes));
  }
}

void check_boundary(const AbaqusDeck& deck, const AbaqusDeck::Boundary& boundary, const std::string& source) {
  require_nodes(deck, boundary.nodes, source, boundary.line);
  if (!boundary.amplitude.empty()) {
    require(deck.amplitudes, boundary.amplitude, "the amplitude", source, boundary.line);
  }
}

void check_contact(const AbaqusDeck& deck, const std::string& source) {
  for (const auto& [name, surface] : deck.surfaces) {
    for (const std::string& set : surface.sets) {
      if (surface.type == "ELEMENT") require(deck.element_sets, set, "the element set", source, surface.line);
    }
  }
  if (!deck.contact) return;
  const int line = deck.contact->line;
  const auto require_surface = [&](const std::string& name) {
    if (!name.empty()) require(deck.surfaces, name, "the surface", source, line);
  };
  for (const auto& [surface_a, surface_b] : deck.contact->inclusions) {
    require_surface(surface_a);
    require_surface(surface_b);
  }
  for (const AbaqusDeck::Contact::Property& property : deck.contact->properties) {
    require_surface(property.surface_a);
    require_surface(property.surface_b);
    require(deck.interactions, property.interaction, "the surface interaction", source, line);
  }
  for (const auto& [surface, thickness] : deck.contact->thickness) require_surface(surface);
}

}  // namespace

void check_references(const AbaqusDeck& deck, const std::string& source) {
  check_elements(deck, source);
  check_sets(deck.node_sets, deck.nodes, "node", source);
  check_sets(deck.element_sets, deck.elements, "element", source);
  check_sections(deck, source);
  check_contact(deck, source);
  for (const AbaqusDeck::Equation& equation : deck.equations) {
    for (const AbaqusDeck::Equation::Term& term : equation.terms) {
      require_nodes(deck, term.nodes, source, equation.line);
    }
  }
  for (const AbaqusDeck::Boundary& boundary : deck.boundaries) check_boundary(deck, boundary, source);
  for (const AbaqusDeck::Step& step : deck.steps) {
    for (const AbaqusDeck::Boundary& boundary : step.boundaries) check_boundary(deck, boundary, source);
  }
}

}  // namespace knitmech::exchange
