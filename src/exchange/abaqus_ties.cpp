#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <ostream>
#include <set>
#include <stdexcept>
#include <vector>

#include "exchange/abaqus_number.h"
#include "exchange/abaqus_parts.h"

namespace knitmech::exchange::deck {

namespace {

struct Term {
  int node;  ///< from 0
  double coefficient;
};
using Terms = std::array<Term, 4>;

/// Displacement of the first place minus that of the second, on the straight elements.
Terms terms_of(const model::Tie& tie) {
  return {{{tie.first.element, 1 - tie.first.share},
           {tie.first.element + 1, tie.first.share},
           {tie.second.element, tie.second.share - 1},
           {tie.second.element + 1, -tie.second.share}}};
}

std::set<int> nodes_in_grips(const model::Model& model) {
  std::set<int> held;
  for (const std::string& set : {model.test.held_set, model.test.driven_set}) {
    const std::vector<int>& nodes = model.node_sets.at(set);
    held.insert(nodes.begin(), nodes.end());
  }
  return held;
}

/// Brings a term to the front whose node no other equation eliminates, no grip holds and, where there is one, no other
/// equation has: Abaqus eliminates the first.
void put_eliminated_first(Terms& terms, const std::map<int, int>& uses, std::set<int>& taken) {
  const auto rank = [&](const Term& term) {
    if (taken.contains(term.node) || term.coefficient == 0) return 0.0;
    return std::abs(term.coefficient) + (uses.at(term.node) == 1 ? 2.0 : 0.0);
  };
  auto* const best =
      std::max_element(terms.begin(), terms.end(), [&](const Term& a, const Term& b) { return rank(a) < rank(b); });
  if (rank(*best) == 0) {
    throw std::invalid_argument("write_abaqus: a tie has no node of its own that its equation could eliminate");
  }
  taken.insert(best->node);
  std::iter_swap(terms.begin(), best);
}

void write_equation(std::ostream& out, const Terms& terms, int direction) {
  const auto count = std::ranges::count_if(terms, [](const Term& term) { return term.coefficient != 0; });
  line(out, "{}", count);
  std::vector<std::string> entries;
  for (const Term& term : terms) {
    if (term.coefficient == 0) continue;
    entries.push_back(fmt::format("{}, {}, {}", term.node + 1, direction, abaqus_number(term.coefficient)));
  }
  line(out, "{}", fmt::join(entries, ", "));
}

}  // namespace

void write_ties(std::ostream& out, const model::Model& model) {
  if (model.ties.empty()) return;
  caption(out, "TIES: yarns that keep their relative position where they cross at the side edges");
  std::map<int, int> uses;
  for (const model::Tie& tie : model.ties) {
    for (const Term& term : terms_of(tie)) ++uses[term.node];
  }
  std::set<int> taken = nodes_in_grips(model);
  out << "*EQUATION\n";
  for (const model::Tie& tie : model.ties) {
    Terms terms = terms_of(tie);
    put_eliminated_first(terms, uses, taken);
    for (const int direction : {1, 2, 3}) write_equation(out, terms, direction);
  }
}

}  // namespace knitmech::exchange::deck
