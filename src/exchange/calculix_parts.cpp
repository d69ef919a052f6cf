#include "exchange/calculix_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>

#include "base/errors.h"
#include "exchange/abaqus_number.h"
#include "exchange/constants.h"
#include "model/places.h"

namespace knitmech::exchange::deck {
namespace {

bool has_nodes(const model::Model& model, const std::string& set) {
  const auto found = model.node_sets.find(set);
  return found != model.node_sets.end() && !found->second.empty();
}

/// Groups of yarns that hold each other: the first yarn of its group for each yarn.
std::vector<int> groups_of_yarns(const model::Model& model, bool touching_holds) {
  std::vector<int> group(model.yarns.size());
  std::iota(group.begin(), group.end(), 0);
  const auto join = [&](int a, int b) {
    const int from = group[static_cast<std::size_t>(std::max(a, b))],
              to = group[static_cast<std::size_t>(std::min(a, b))];
    std::ranges::replace(group, from, to);
  };
  for (const model::Tie& tie : model.ties) {
    join(model::yarn_of_node(model, static_cast<std::size_t>(tie.first.element)),
         model::yarn_of_node(model, static_cast<std::size_t>(tie.second.element)));
  }
  for (int i = 1; touching_holds && i < static_cast<int>(group.size()); ++i) join(i - 1, i);
  return group;
}

std::set<int> groups_with(const model::Model& model, const std::vector<int>& group, const std::string& set) {
  std::set<int> groups;
  for (const int node : model.node_sets.at(set)) {
    groups.insert(group[static_cast<std::size_t>(model::yarn_of_node(model, static_cast<std::size_t>(node)))]);
  }
  return groups;
}

void write_set(std::ostream& out, const char* name, const std::set<int>& nodes) {
  line(out, "*NSET, NSET={}", name);
  write_entries(out, std::vector<int>(nodes.begin(), nodes.end()));
}

}  // namespace

void GripNodes::add(Grip grip, int node) {
  if (grip == Grip::held) held.insert(node);
  if (grip == Grip::driven) driven.insert(node);
}

void check_holds(const model::Model& model, const char* format, bool touching_holds) {
  for (const std::string& grip : {model.test.held_set, model.test.driven_set}) {
    if (!has_nodes(model, grip))
      throw InputError(fmt::format("{}: the model has no nodes in its grip {}", format, grip));
  }
  const std::vector<int> group = groups_of_yarns(model, touching_holds);
  const std::set<int> held = groups_with(model, group, model.test.held_set);
  const std::set<int> driven = groups_with(model, group, model.test.driven_set);
  const bool all_held =
      std::ranges::all_of(group, [&](int each) { return held.contains(each) || driven.contains(each); });
  const bool joined = std::ranges::any_of(held, [&](int each) { return driven.contains(each); });
  if (all_held && joined) return;
  throw InputError(
      fmt::format("{}: this deck has no contact, and only contact joins the courses of this fabric; export one course "
                  "(fabric.courses "
                  "= 1), a tied or an adjusted fabric, or take -f calculix-solids",
                  format));
}

void write_calculix_heading(std::ostream& out, const model::Model& model, const std::vector<std::string>& comments) {
  write_heading(out, model);
  out << "**\n";
  for (const std::string& each : comments) line(out, "** {}", each);
  const model::TensileTest& test = model.test;
  line(out, "** Units: length mm, force N, stress MPa. x runs along the courses, y along the wales, z out of plane.");
  line(out, "** {} is held, {} is driven along y over the time 0 to 1.", kHeldGrip, kDrivenGrip);
  line(out, "** Strain = {} times the time (displacement over {} mm).", abaqus_number(test.strain),
       abaqus_number(test.gauge_length));
  line(out,
       "** The .dat file has the sum of the forces on each grip, at about a hundred instants: fy of {} is the pull.",
       kDrivenGrip);
  if (!model.axial_laws.empty()) {
    line(out,
         "** The yarn follows a measured curve in KnitMech; here it is linear, with the slope of the curve at zero.");
  }
  if (!model.strengths.empty()) line(out, "** The yarn breaks in KnitMech; here it does not.");
}

void write_grip_sets(std::ostream& out, const GripNodes& grips) {
  caption(out, "GRIPS");
  write_set(out, kHeldGrip, grips.held);
  write_set(out, kDrivenGrip, grips.driven);
}

void write_calculix_equations(std::ostream& out, std::vector<EquationTerm> terms, const GripNodes& grips,
                              std::set<int>& eliminated) {
  const auto first = std::ranges::find_if(
      terms, [&](const EquationTerm& term) { return !grips.contains(term.node) && !eliminated.contains(term.node); });
  if (first == terms.end()) return;
  eliminated.insert(first->node);
  std::iter_swap(terms.begin(), first);
  for (const int direction : {1, 2, 3}) {
    line(out, "*EQUATION\n{}", terms.size());
    for (std::size_t i = 0; i < terms.size(); i += kCalculixEquationTerms) {
      std::vector<std::string> entries;
      for (std::size_t k = i; k < std::min(terms.size(), i + kCalculixEquationTerms); ++k) {
        entries.push_back(fmt::format("{}, {}, {}", terms[k].node, direction, abaqus_number(terms[k].coefficient)));
      }
      line(out, "{}", fmt::join(entries, ", "));
    }
  }
}

void write_static_step(std::ostream& out, const StaticStep& step) {
  caption(out, "THE TEST");
  line(out, "*STEP, NLGEOM, INC={}", kCalculixIncrements);
  out << step.controls << "*STATIC\n";
  const std::string increment = abaqus_number(step.increment);
  line(out, "{}, 1., {}, {}", increment, abaqus_number(kCalculixLeastIncrement), increment);
  out << "*BOUNDARY\n" << step.driven;
  // CalculiX has one frequency for all output of a step.
  const int every = std::max(1, static_cast<int>(std::lround(1 / (step.increment * kCalculixStates))));
  for (const char* grip : {kDrivenGrip, kHeldGrip}) {
    line(out, "*NODE PRINT, NSET={}, TOTALS=ONLY, GLOBAL=YES, FREQUENCY={}\nRF", grip, every);
  }
  line(out, "*NODE FILE, FREQUENCY={0}\nU, RF\n*EL FILE, FREQUENCY={0}\nS", every);
  if (step.contact) line(out, "*CONTACT FILE, FREQUENCY={}\nCDIS, CSTR", every);
  out << "*END STEP\n";
}

}  // namespace knitmech::exchange::deck
