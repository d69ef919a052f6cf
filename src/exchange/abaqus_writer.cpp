#include "exchange/abaqus_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/abaqus_number.h"
#include "exchange/abaqus_parts.h"
#include "exchange/constants.h"

namespace knitmech::exchange {

namespace {

using deck::caption;
using deck::line;
using deck::SectionGroup;

void comment(std::ostream& out, std::string_view text) {
  out << "** " << text << '\n';
}

/// Element sets of the yarns: by course where every course is one yarn, by yarn otherwise.
std::vector<std::string> yarn_sets(const model::Model& model) {
  const std::set<int> courses(model.course.begin(), model.course.end());
  const bool by_course = model.has_stitches && courses.size() == model.yarns.size();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.yarns.size(); ++i) {
    const auto first = static_cast<std::size_t>(model.yarns[i].first_node);
    names.push_back(by_course ? fmt::format("COURSE_{}", model.course[first] + 1) : fmt::format("YARN_{}", i + 1));
  }
  return names;
}

void write_introduction(std::ostream& out, const model::Model& model) {
  const model::TensileTest& test = model.test;
  out << "**\n";
  comment(out, "A knitted fabric, yarn by yarn, in a tensile test; for Abaqus/Explicit, in double precision.");
  comment(out, "Units: length mm, force N, time s, mass t, stress MPa, energy mJ, density t/mm^3.");
  comment(out, "x runs along the courses, y along the wales, z out of the plane of the fabric.");
  comment(out, fmt::format("{} {}, {} nodes, {} beam elements.", model.yarns.size(),
                           model.yarns.size() == 1 ? "yarn" : "yarns", model.n_nodes(), model.n_elements()));
  comment(out,
          fmt::format("The node set {} is held, the node set {} is driven along y.", test.held_set, test.driven_set));
  comment(out, fmt::format("Strain = displacement of {} / {} mm.", test.driven_set, abaqus_number(test.gauge_length)));
  comment(out, "The shape given here is free of stress.");
  out << "**\n";
  comment(out, "Lines to change for");
  comment(
      out,
      "  another yarn       *BEAM SECTION (radius) or *BEAM GENERAL SECTION, *MATERIAL, *TRANSVERSE SHEAR STIFFNESS");
  comment(out, "  another friction   *FRICTION");
  comment(out, "  another speed      *BOUNDARY, TYPE=VELOCITY, and with it the times of *AMPLITUDE and *DYNAMIC");
  comment(out, "  another strain     *DYNAMIC (duration), and the last time of *AMPLITUDE");
  comment(out,
          "  a faster run       *FIXED MASS SCALING, FACTOR=f after *DYNAMIC: masses times f, time step times sqrt(f)");
  comment(out, "  more pictures      *OUTPUT, FIELD (NUMBER INTERVAL)");
}

void write_nodes(std::ostream& out, const model::Model& model) {
  caption(out, "NODES");
  out << "*NODE\n";
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    deck::write_node(out, static_cast<int>(i) + 1, model.nodes[i]);
  }
}

void write_elements(std::ostream& out, const model::Model& model) {
  caption(out, "YARNS: two-node shear-flexible beams");
  const std::vector<std::string> names = yarn_sets(model);
  int number = 0;
  for (std::size_t k = 0; k < model.yarns.size(); ++k) {
    const model::ModelYarn& yarn = model.yarns[k];
    line(out, "*ELEMENT, TYPE=B31, ELSET={}", names[k]);
    for (int i = yarn.first_node; i < yarn.first_node + yarn.n_nodes - 1; ++i) {
      line(out, "{}, {}, {}", ++number, i + 1, i + 2);
    }
  }
}

/// Yarns that have one section throughout by name, the elements of others by number.
std::vector<std::string> members_of_section(const model::Model& model, int section) {
  const std::vector<std::string> names = yarn_sets(model);
  std::vector<std::string> members;
  int before = 0;  // elements of the yarns before
  for (std::size_t k = 0; k < model.yarns.size(); ++k) {
    const auto first = model.element_section.begin() + model.yarns[k].first_node;
    const int n_elements = model.yarns[k].n_nodes - 1;
    const auto count = std::count(first, first + n_elements, section);
    if (count == n_elements) {
      members.push_back(names[k]);
    } else if (count > 0) {
      for (int i = 0; i < n_elements; ++i) {
        if (first[i] == section) members.push_back(std::to_string(before + i + 1));
      }
    }
    before += n_elements;
  }
  return members;
}

void write_element_sets(std::ostream& out, const model::Model& model, const std::vector<SectionGroup>& groups) {
  caption(out, "ELEMENT SETS: the elements of each section, and all of them");
  std::vector<std::string> sections;
  for (int section = 0; section < static_cast<int>(model.sections.size()); ++section) {
    const std::vector<std::string> members = members_of_section(model, section);
    if (members.empty()) continue;
    sections.push_back(deck::section_set(section));
    line(out, "*ELSET, ELSET={}", sections.back());
    deck::write_entries(out, members);
  }
  line(out, "*ELSET, ELSET={}", deck::kAllElements);
  deck::write_entries(out, sections);
  for (const SectionGroup& group : groups) {
    if (group.set == deck::section_set(group.section)) continue;
    line(out, "*ELSET, ELSET={}", group.set);
    deck::write_entries(out, group.elements);
  }
}

void write_node_sets(std::ostream& out, const model::Model& model) {
  caption(out, "NODE SETS");
  for (const auto& [name, nodes] : model.node_sets) {
    if (nodes.empty()) continue;
    line(out, "*NSET, NSET={}", name);
    std::vector<int> numbers(nodes);
    for (int& number : numbers) ++number;
    deck::write_entries(out, numbers);
  }
}

void require_grip(const model::Model& model, const std::string& name) {
  const auto set = model.node_sets.find(name);
  if (set == model.node_sets.end() || set->second.empty()) {
    throw std::invalid_argument(fmt::format("write_abaqus: the model has no nodes in its grip {}", name));
  }
}

}  // namespace

void write_abaqus(std::ostream& out, const model::Model& model, const AbaqusOptions& options) {
  require_grip(model, model.test.held_set);
  require_grip(model, model.test.driven_set);
  const std::vector<SectionGroup> groups = deck::section_groups(model);
  deck::write_heading(out, model);
  write_introduction(out, model);
  write_nodes(out, model);
  write_elements(out, model);
  write_element_sets(out, model, groups);
  write_node_sets(out, model);
  deck::write_materials(out, model);  // before the sections, which name them
  deck::write_sections(out, model, groups);
  deck::write_ties(out, model);
  deck::write_contact(out, model, groups);
  deck::write_grips(out, model.test);
  deck::write_step(out, model.test, options);
}

}  // namespace knitmech::exchange
