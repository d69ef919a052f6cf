#include "exchange/tie_equations.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace knitmech::exchange {

namespace {

using Term = TieEquation::Term;

/// Displacement of the first place minus that of the second, on the straight elements.
std::vector<Term> terms_of(const model::Tie& tie) {
  std::vector<Term> terms = {{tie.first.element, 1 - tie.first.share},
                             {tie.first.element + 1, tie.first.share},
                             {tie.second.element, tie.second.share - 1},
                             {tie.second.element + 1, -tie.second.share}};
  std::erase_if(terms, [](const Term& term) { return term.coefficient == 0; });
  return terms;
}

std::set<int> nodes_in_grips(const model::Model& model) {
  std::set<int> held;
  for (const std::string& set : {model.test.held_set, model.test.driven_set}) {
    const std::vector<int>& nodes = model.node_sets.at(set);
    held.insert(nodes.begin(), nodes.end());
  }
  return held;
}

void put_eliminated_first(std::vector<Term>& terms, const std::map<int, int>& uses, std::set<int>& taken) {
  const auto rank = [&](const Term& term) {
    if (taken.contains(term.node)) return 0.0;
    return std::abs(term.coefficient) + (uses.at(term.node) == 1 ? 2.0 : 0.0);
  };
  const auto best =
      std::max_element(terms.begin(), terms.end(), [&](const Term& a, const Term& b) { return rank(a) < rank(b); });
  if (best == terms.end() || rank(*best) == 0) {
    throw std::invalid_argument("tie_equations: a tie has no node of its own that its equation could eliminate");
  }
  taken.insert(best->node);
  std::iter_swap(terms.begin(), best);
}

}  // namespace

std::vector<TieEquation> tie_equations(const model::Model& model) {
  std::vector<TieEquation> equations;
  if (model.ties.empty()) return equations;
  std::map<int, int> uses;
  for (const model::Tie& tie : model.ties) {
    for (const int element : {tie.first.element, tie.second.element}) {
      ++uses[element];
      ++uses[element + 1];
    }
  }
  std::set<int> taken = nodes_in_grips(model);
  for (const model::Tie& tie : model.ties) {
    std::vector<Term> terms = terms_of(tie);
    put_eliminated_first(terms, uses, taken);
    equations.push_back({std::move(terms)});
  }
  return equations;
}

}  // namespace knitmech::exchange
