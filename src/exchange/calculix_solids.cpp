#include "exchange/calculix_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

#include "base/errors.h"
#include "exchange/abaqus_number.h"
#include "exchange/calculix_parts.h"
#include "exchange/calculix_section.h"
#include "exchange/constants.h"
#include "exchange/tube_hexahedra.h"

namespace knitmech::exchange {
namespace {

using deck::caption;
using deck::line;

constexpr const char* kFormat = "calculix-solids";

/// A yarn with the numbers of its first node and element in the deck.
struct Solid {
  YarnPath path;
  TubeHexahedra tube;
  int first_node = 1, first_element = 1;
  int course = 0;

  [[nodiscard]] int number(int node) const { return first_node + node; }
  [[nodiscard]] std::string name() const { return fmt::format("YARN_{}", tube.yarn + 1); }
  [[nodiscard]] std::string surface() const { return fmt::format("SURFACE_{}", tube.yarn + 1); }
};

void check_yarns(const model::Model& model) {
  if (!model.pair_friction.empty() || model.sections.size() > 1) {
    throw InputError(
        fmt::format("{}: an adjusted fabric is one yarn that touches itself, and CalculiX has no contact of a surface "
                    "with itself; set fabric.structure to basic or tied",
                    kFormat));
  }
}

std::vector<Solid> solids_of(const model::Model& model) {
  const PathOptions options{
      .largest_length = kSolidLargestLength, .largest_turn = kSolidLargestTurn, .shortest = kShortestAtGrip};
  std::vector<Solid> solids;
  int node = 1, element = 1;
  for (YarnPath& path : yarn_paths(model, options)) {
    const auto first = static_cast<std::size_t>(path.points.front().element);
    Solid solid;
    solid.path = std::move(path);
    solid.course = model.course[first];
    solid.tube = tube_hexahedra(solid.path, 0.5 * model.section_of(first).diameter);
    solid.first_node = node;
    solid.first_element = element;
    node += static_cast<int>(solid.tube.nodes.size());
    element += static_cast<int>(solid.tube.elements.size());
    solids.push_back(std::move(solid));
  }
  return solids;
}

void write_mesh(std::ostream& out, const std::vector<Solid>& solids) {
  caption(out, "YARNS: 20-node hexahedra, five across the section, the inner one first");
  for (const Solid& solid : solids) {
    out << "*NODE\n";
    for (std::size_t i = 0; i < solid.tube.nodes.size(); ++i) {
      deck::write_node(out, solid.number(static_cast<int>(i)), solid.tube.nodes[i]);
    }
    line(out, "*ELEMENT, TYPE=C3D20R, ELSET={}", solid.name());
    int number = solid.first_element;
    for (const std::array<int, 20>& element : solid.tube.elements) {
      std::array<int, 20> nodes{};
      std::ranges::transform(element, nodes.begin(), [&](int node) { return solid.number(node); });
      line(out, "{}, {},", number++, fmt::join(nodes.begin(), nodes.begin() + kNodesOnFirstLine, ", "));
      line(out, "{}", fmt::join(nodes.begin() + kNodesOnFirstLine, nodes.end(), ", "));
    }
  }
}

void write_material(std::ostream& out, const model::Model& model, const std::vector<Solid>& solids) {
  caption(out, "MATERIAL");
  const CalculixMaterial material = calculix_material(model.sections.front());
  line(out, "*MATERIAL, NAME=YARN\n*ELASTIC\n{}, {}", abaqus_number(material.youngs_modulus),
       abaqus_number(material.poissons_ratio));
  for (const Solid& solid : solids) line(out, "*SOLID SECTION, ELSET={}, MATERIAL=YARN", solid.name());
}

void write_surfaces(std::ostream& out, const std::vector<Solid>& solids) {
  caption(out, "SURFACES of the yarns");
  for (const Solid& solid : solids) {
    std::vector<int> outer;
    for (std::size_t i = 0; i < solid.tube.elements.size(); ++i) {
      if (i % kSectionQuads != 0) outer.push_back(solid.first_element + static_cast<int>(i));
    }
    line(out, "*ELSET, ELSET={}_OUTER", solid.name());
    deck::write_entries(out, outer);
    line(out, "*SURFACE, NAME={}, TYPE=ELEMENT\n{}_OUTER, S{}", solid.surface(), solid.name(), kOuterFace);
  }
}

void write_contact(std::ostream& out, const model::Model& model, const std::vector<Solid>& solids) {
  caption(out, "CONTACT of each yarn with those of its own and of the next course: pressure per penetration; friction");
  const double diameter = model.sections.front().diameter;
  const double stiffness = kPressureStiffnessShare * model.contact_stiffness / (diameter * diameter);
  line(out, "*SURFACE INTERACTION, NAME=YARN_ON_YARN\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{}, 0.",
       abaqus_number(stiffness));
  if (model.friction > 0) {
    line(out, "*FRICTION\n{}, {}", abaqus_number(model.friction), abaqus_number(kStickShare * stiffness));
  }
  for (const Solid& upper : solids) {
    for (const Solid& lower : solids) {
      if (lower.tube.yarn >= upper.tube.yarn || std::abs(lower.course - upper.course) > 1) continue;
      line(out, "*CONTACT PAIR, INTERACTION=YARN_ON_YARN, TYPE=SURFACE TO SURFACE\n{}, {}", upper.surface(),
           lower.surface());
    }
  }
}

deck::GripNodes grips_of(const std::vector<Solid>& solids) {
  deck::GripNodes grips;
  for (const Solid& solid : solids) {
    for (std::size_t i = 0; i < solid.path.points.size(); ++i) {
      for (const int node : solid.tube.rings[i]) grips.add(solid.path.points[i].grip, solid.number(node));
    }
  }
  return grips;
}

/// The mean of the corners of the inner square at a place, times a factor.
std::vector<deck::EquationTerm> centre_at(const std::vector<Solid>& solids, const model::ElementPlace& place,
                                          double factor) {
  const auto solid = std::ranges::find_if(solids, [&](const Solid& each) {
    return each.path.points.front().element <= place.element && place.element <= each.path.points.back().element;
  });
  const std::vector<int>& ring = solid->tube.rings[end_at(solid->path, place)];
  std::vector<deck::EquationTerm> terms;
  for (std::size_t k = 0; k < 4; ++k) terms.push_back({solid->number(ring[k]), factor / 4});
  return terms;
}

void write_solid_ties(std::ostream& out, const model::Model& model, const std::vector<Solid>& solids,
                      const deck::GripNodes& grips) {
  if (model.ties.empty()) return;
  caption(out, "TIES: sections of two yarns that move together");
  std::set<int> eliminated;
  for (const model::Tie& tie : model.ties) {
    std::vector<deck::EquationTerm> terms = centre_at(solids, tie.first, 1);
    const std::vector<deck::EquationTerm> others = centre_at(solids, tie.second, -1);
    terms.insert(terms.end(), others.begin(), others.end());
    deck::write_calculix_equations(out, std::move(terms), grips, eliminated);
  }
}

}  // namespace

void write_calculix_solids(std::ostream& out, const model::Model& model) {
  check_yarns(model);
  deck::check_holds(model, kFormat, true);
  const std::vector<Solid> solids = solids_of(model);
  const deck::GripNodes grips = grips_of(solids);
  std::ostringstream text;  // a section may be refused halfway
  deck::write_calculix_heading(text, model,
                               {"The yarns of a knitted fabric as solid tubes with contact and friction, for CalculiX",
                                "(ccx). It is for small fabrics: docs/calculix.md has sizes and times."});
  write_mesh(text, solids);
  write_material(text, model, solids);
  write_surfaces(text, solids);
  write_contact(text, model, solids);
  deck::write_grip_sets(text, grips);
  write_solid_ties(text, model, solids, grips);
  deck::write_static_step(text, model.test, false, true);
  out << std::move(text).str();
}

}  // namespace knitmech::exchange
