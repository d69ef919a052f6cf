#include <fmt/format.h>

#include <ostream>
#include <string>
#include <vector>

#include "exchange/abaqus_number.h"
#include "exchange/abaqus_parts.h"
#include "exchange/tie_equations.h"

namespace knitmech::exchange::deck {

namespace {

void write_equation(std::ostream& out, const TieEquation& equation, int direction) {
  line(out, "{}", equation.terms.size());
  std::vector<std::string> entries;
  for (const TieEquation::Term& term : equation.terms) {
    entries.push_back(fmt::format("{}, {}, {}", term.node + 1, direction, abaqus_number(term.coefficient)));
  }
  line(out, "{}", fmt::join(entries, ", "));
}

}  // namespace

void write_ties(std::ostream& out, const model::Model& model) {
  if (model.ties.empty()) return;
  caption(out, "TIES: yarns that keep their relative position where they cross at the side edges");
  out << "*EQUATION\n";
  for (const TieEquation& equation : tie_equations(model)) {
    for (const int direction : {1, 2, 3}) write_equation(out, equation, direction);
  }
}

}  // namespace knitmech::exchange::deck
