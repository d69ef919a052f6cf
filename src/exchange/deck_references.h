#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/abaqus_lines.h"

/// What the checks of decks whose things have numbers share.
namespace knitmech::exchange {

/// Throws InputError "source, line n: the WHAT NUMBER does not exist" if a map has no such number.
template <typename Map>
void require_known(const Map& known, int number, std::string_view what, const std::string& source, int line) {
  if (!known.contains(number)) fail_at(source, line, fmt::format("the {} {} does not exist", what, number));
}

/// Every member of every group, none of which may be empty. \param groups by number, each with `members` and `line`
template <typename Groups, typename Map>
void require_members(const Groups& groups, const Map& known, std::string_view what, const std::string& source) {
  for (const auto& [number, group] : groups) {
    if (group.members.empty()) fail_at(source, group.line, fmt::format("the group {} is empty", number));
    for (const int member : group.members) require_known(known, member, what, source, group.line);
  }
}

/// The nodes, the part and that no node comes twice, of every beam; a beam for every part.
template <typename Deck>
void require_beams(const Deck& deck, const std::string& source) {
  std::vector<int> parts;
  for (const auto& [number, beam] : deck.beams) {
    require_known(deck.parts, beam.part, "part", source, beam.line);
    parts.push_back(beam.part);
    for (const int node : beam.nodes) require_known(deck.nodes, node, "node", source, beam.line);
    const auto& [first, last, third] = beam.nodes;
    if (first == last || first == third || last == third) {
      fail_at(source, beam.line, fmt::format("the beam {} has a node twice", number));
    }
  }
  for (const auto& [number, part] : deck.parts) {
    if (std::ranges::find(parts, number) != parts.end()) continue;
    fail_at(source, part.line, fmt::format("the part {} has no beams", number));
  }
}

/// Terms of a constraint: two or more, of nodes that there are, in directions 1 to 6.
/// \param is_held (node, direction from 0) whether it is held, which a constrained one must not be
template <typename Constraint, typename Nodes, typename IsHeld>
void require_terms(const Constraint& constraint, int number, const Nodes& nodes, const IsHeld& is_held,
                   const std::string& source) {
  if (constraint.terms.size() < 2) {
    fail_at(source, constraint.line, fmt::format("the constraint {} has less than two terms", number));
  }
  for (const auto& term : constraint.terms) {
    require_known(nodes, term.node, "node", source, constraint.line);
    if (term.direction < 1 || term.direction > 6) {
      fail_at(source, constraint.line, fmt::format("a direction is 1 to 6, not {}", term.direction));
    }
    if (is_held(term.node, static_cast<std::size_t>(term.direction) - 1)) {
      fail_at(source, constraint.line, fmt::format("the node {} is constrained and held", term.node));
    }
  }
}

/// Whether an entry of held directions, from 0, with the number of its group, holds a node.
template <typename Held, typename Groups>
[[nodiscard]] bool holds(const Held& held, const Groups& groups, int node, std::size_t direction) {
  const std::vector<int>& members = groups.at(held.group).members;
  return held.directions.at(direction) && std::ranges::find(members, node) != members.end();
}

/// Value of a curve: linear between its points, constant before the first and after the last. \param points not empty
template <typename Points>
[[nodiscard]] double value_of_curve(const Points& points, double x) {
  if (x <= points.front().first) return points.front().second;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto& [x_before, y_before] = points[i - 1];
    const auto& [x_after, y_after] = points[i];
    if (x <= x_after) return y_before + (y_after - y_before) * (x - x_before) / (x_after - x_before);
  }
  return points.back().second;
}

}  // namespace knitmech::exchange
