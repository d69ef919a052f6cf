#include "exchange/calculix_solids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

#include "base/errors.h"
#include "exchange/abaqus_number.h"
#include "exchange/calculix_clamps.h"
#include "exchange/calculix_parts.h"
#include "exchange/calculix_section.h"
#include "exchange/constants.h"
#include "exchange/tube_hexahedra.h"
#include "model/places.h"

namespace knitmech::exchange {
namespace {

using deck::caption;
using deck::line;

constexpr const char* kFormat = "calculix-solids";

/// A piece of a yarn with the numbers of its first node and element in the deck. A yarn is cut where a grip begins: its
/// part in the grip is a body of its own, so that it does not keep the free part from contracting at its clamped end.
struct Solid {
  YarnPath path;
  TubeHexahedra tube;
  int first_node = 1, first_element = 1;
  int course = 0;
  bool in_grip = false;

  [[nodiscard]] int number(int node) const { return first_node + node; }
};

std::string yarn_name(int yarn) {
  return fmt::format("YARN_{}", yarn + 1);
}

std::string surface_name(int yarn) {
  return fmt::format("SURFACE_{}", yarn + 1);
}

void check_yarns(const model::Model& model) {
  if (model.test.grips == model::Grips::sliding) {
    throw InputError(
        fmt::format("{}: this deck has no grips that slide; set test.grips to clamped, or take -f abaqus", kFormat));
  }
  if (!model.pair_friction.empty() || model.sections.size() > 1) {
    throw InputError(
        fmt::format("{}: an adjusted fabric is one yarn that touches itself, and CalculiX has no contact of a surface "
                    "with itself; set fabric.structure to basic or tied",
                    kFormat));
  }
}

std::vector<Solid> solids_of(const model::Model& model) {
  const PathOptions options{
      .largest_length = kSolidLargestLength, .largest_turn = kSolidLargestTurn, .shortest = kSolidShortest};
  std::vector<Solid> solids;
  int node = 1, element = 1;
  for (const YarnPath& path : yarn_paths(model, options)) {
    const auto first = static_cast<std::size_t>(path.points.front().element);
    for (YarnPath& piece : cut_at_grips(path)) {
      Solid solid;
      solid.path = std::move(piece);
      solid.course = model.course[first];
      solid.in_grip = lies_in_grip(solid.path);
      solid.tube = tube_hexahedra(solid.path, 0.5 * model.section_of(first).diameter);
      solid.first_node = node;
      solid.first_element = element;
      node += static_cast<int>(solid.tube.nodes.size());
      element += static_cast<int>(solid.tube.elements.size());
      solids.push_back(std::move(solid));
    }
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
    line(out, "*ELEMENT, TYPE=C3D20R, ELSET={}", yarn_name(solid.tube.yarn));
    int number = solid.first_element;
    for (const std::array<int, 20>& element : solid.tube.elements) {
      std::array<int, 20> nodes{};
      std::ranges::transform(element, nodes.begin(), [&](int node) { return solid.number(node); });
      line(out, "{}, {},", number++, fmt::join(nodes.begin(), nodes.begin() + kNodesOnFirstLine, ", "));
      line(out, "{}", fmt::join(nodes.begin() + kNodesOnFirstLine, nodes.end(), ", "));
    }
  }
}

void write_material(std::ostream& out, const model::Model& model) {
  caption(out, "MATERIAL");
  const CalculixMaterial material = calculix_material(model.sections.front());
  line(out, "*MATERIAL, NAME=YARN\n*ELASTIC\n{}, {}", abaqus_number(material.youngs_modulus),
       abaqus_number(material.poissons_ratio));
  for (int yarn = 0; yarn < static_cast<int>(model.yarns.size()); ++yarn) {
    line(out, "*SOLID SECTION, ELSET={}, MATERIAL=YARN", yarn_name(yarn));
  }
}

void write_surfaces(std::ostream& out, const std::vector<Solid>& solids, std::size_t n_yarns) {
  caption(out, "SURFACES of the yarns");
  std::vector<std::vector<int>> outer(n_yarns);
  for (const Solid& solid : solids) {
    for (std::size_t i = 0; i < solid.tube.elements.size(); ++i) {
      const int number = solid.first_element + static_cast<int>(i);
      if (i % kSectionQuads != 0) outer[static_cast<std::size_t>(solid.tube.yarn)].push_back(number);
    }
  }
  for (int yarn = 0; yarn < static_cast<int>(n_yarns); ++yarn) {
    line(out, "*ELSET, ELSET={}_OUTER", yarn_name(yarn));
    deck::write_entries(out, outer[static_cast<std::size_t>(yarn)]);
    line(out, "*SURFACE, NAME={}, TYPE=ELEMENT\n{}_OUTER, S{}", surface_name(yarn), yarn_name(yarn), kOuterFace);
  }
}

/// Course of each yarn.
std::vector<int> courses_of_yarns(const std::vector<Solid>& solids) {
  std::vector<int> courses;
  for (const Solid& solid : solids) {
    if (static_cast<std::size_t>(solid.tube.yarn) == courses.size()) courses.push_back(solid.course);
  }
  return courses;
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
  const std::vector<int> courses = courses_of_yarns(solids);
  for (int upper = 0; upper < static_cast<int>(courses.size()); ++upper) {
    for (int lower = 0; lower < upper; ++lower) {
      const int apart = courses[static_cast<std::size_t>(upper)] - courses[static_cast<std::size_t>(lower)];
      if (std::abs(apart) > 1) continue;
      line(out, "*CONTACT PAIR, INTERACTION=YARN_ON_YARN, TYPE=SURFACE TO SURFACE\n{}, {}", surface_name(upper),
           surface_name(lower));
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

std::vector<deck::ClampedSection> clamped_sections(const std::vector<Solid>& solids) {
  std::vector<deck::ClampedSection> sections;
  for (const Solid& solid : solids) {
    if (solid.in_grip) continue;
    for (const std::size_t i : {std::size_t{0}, solid.path.points.size() - 1}) {
      if (solid.path.points[i].grip == Grip::none) continue;
      sections.push_back(deck::clamped_section(static_cast<int>(sections.size()) + 1, solid.path.points[i], solid.tube,
                                               solid.tube.rings[i], solid.first_node));
    }
  }
  return sections;
}

/// The nodes of the parts in grips.
deck::GripNodes bodies_in_grips(const std::vector<Solid>& solids) {
  deck::GripNodes bodies;
  for (const Solid& solid : solids) {
    if (!solid.in_grip) continue;
    const Grip grip = solid.path.points.front().grip;
    for (std::size_t i = 0; i < solid.tube.nodes.size(); ++i) bodies.add(grip, solid.number(static_cast<int>(i)));
  }
  return bodies;
}

/// The piece of a yarn with the end nearest to a place; of two that share this end, the one in the grip, whose nodes
/// have the axes of the deck.
const Solid& solid_at(const std::vector<Solid>& solids, int yarn, const model::ElementPlace& place) {
  const Solid* nearest = nullptr;
  std::pair<double, bool> least;
  for (const Solid& solid : solids) {
    if (solid.tube.yarn != yarn) continue;
    const std::pair distance{distance_of_end(solid.path, end_at(solid.path, place), place), !solid.in_grip};
    if (nearest == nullptr || distance < least) {
      nearest = &solid;
      least = distance;
    }
  }
  return *nearest;
}

/// The mean of the corners of the inner square at a place, times a factor.
std::vector<deck::EquationTerm> centre_at(const std::vector<Solid>& solids, int yarn, const model::ElementPlace& place,
                                          double factor) {
  const Solid& solid = solid_at(solids, yarn, place);
  const std::vector<int>& ring = solid.tube.rings[end_at(solid.path, place)];
  std::vector<deck::EquationTerm> terms;
  for (std::size_t k = 0; k < 4; ++k) terms.push_back({solid.number(ring[k]), factor / 4});
  return terms;
}

void write_solid_ties(std::ostream& out, const model::Model& model, const std::vector<Solid>& solids,
                      const deck::GripNodes& grips) {
  if (model.ties.empty()) return;
  caption(out, "TIES: sections of two yarns that move together");
  std::set<int> eliminated;
  for (const model::Tie& tie : model.ties) {
    const auto yarn = [&](const model::ElementPlace& place) {
      return model::yarn_of_node(model, static_cast<std::size_t>(place.element));
    };
    std::vector<deck::EquationTerm> terms = centre_at(solids, yarn(tie.first), tie.first, 1);
    const std::vector<deck::EquationTerm> others = centre_at(solids, yarn(tie.second), tie.second, -1);
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
  write_material(text, model);
  write_surfaces(text, solids, model.yarns.size());
  write_contact(text, model, solids);
  deck::write_grip_sets(text, grips);
  write_solid_ties(text, model, solids, grips);
  const std::vector<deck::ClampedSection> clamps = clamped_sections(solids);
  const deck::GripNodes bodies = bodies_in_grips(solids);
  deck::write_clamps(text, clamps, bodies);
  const double displacement = model.test.strain * model.test.gauge_length;
  deck::StaticStep step;
  step.driven = deck::driven_conditions(clamps, bodies, model.test);
  step.increment = std::min(kCalculixIncrement, kSolidIncrement * model.sections.front().diameter / displacement);
  step.contact = true;
  deck::write_static_step(text, step);
  out << std::move(text).str();
}

}  // namespace knitmech::exchange
