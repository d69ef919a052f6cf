#include <fmt/format.h>

#include <vector>

#include "exchange/abaqus_reading.h"

namespace knitmech::exchange::deck {

namespace {

constexpr std::size_t kEntriesPerTerm = 3;  // node or set, degree of freedom, coefficient

AbaqusDeck::Equation::Term term_from(const Reading& reading, const DataLine& data, std::size_t place) {
  AbaqusDeck::Equation::Term term{data.entry(place), reading.whole(data, place + 1), reading.real(data, place + 2)};
  if (term.nodes.empty()) reading.fail(data.line, "an equation needs a node or a node set in each of its terms");
  return term;
}

}  // namespace

/// A line with the number of terms, then the terms, at most four to a line; one equation after the other.
void read_equations(Reading& reading, const KeywordBlock& block) {
  std::size_t i = 0;
  while (i < block.data.size()) {
    const DataLine& head = block.data[i++];
    if (head.is_blank()) continue;
    const int n_terms = reading.whole(head, 0);
    if (n_terms < 1) reading.fail(head.line, fmt::format("an equation has 1 term or more, not {}", n_terms));
    AbaqusDeck::Equation equation{{}, head.line};
    while (equation.terms.size() < static_cast<std::size_t>(n_terms)) {
      const DataLine& data = reading.data_line(block, i++);
      for (std::size_t place = 0; place + kEntriesPerTerm <= data.entries.size(); place += kEntriesPerTerm) {
        equation.terms.push_back(term_from(reading, data, place));
      }
      if (data.entries.size() < kEntriesPerTerm) {
        reading.fail(data.line, "a term of an equation is a node, a degree of freedom and a coefficient");
      }
    }
    if (equation.terms.size() > static_cast<std::size_t>(n_terms)) {
      reading.fail(head.line,
                   fmt::format("the equation has {} terms, but announces {}", equation.terms.size(), n_terms));
    }
    reading.deck.equations.push_back(std::move(equation));
  }
}

}  // namespace knitmech::exchange::deck
