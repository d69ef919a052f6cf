#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/text.h"
#include "exchange/deck_references.h"
#include "exchange/openradioss_reader.h"

namespace knitmech::exchange {

double OpenRadiossDeck::Function::value(double x) const {
  return value_of_curve(points, x);
}

namespace {

void check_mesh(const OpenRadiossDeck& deck, const std::string& source) {
  for (const auto& [number, part] : deck.parts) {
    require_known(deck.properties, part.property, "property", source, part.line);
    require_known(deck.materials, part.material, "material", source, part.line);
  }
  require_beams(deck, source);
  require_members(deck.groups, deck.nodes, "node", source);
  require_members(deck.lines, deck.parts, "part", source);
}

void check_contact(const OpenRadiossDeck& deck, const std::string& source) {
  for (const auto& [number, contact] : deck.contacts) {
    require_known(deck.lines, contact.secondary, "line", source, contact.line);
    if (contact.main != 0) require_known(deck.lines, contact.main, "line", source, contact.line);
    if (contact.friction_table != 0) {
      require_known(deck.frictions, contact.friction_table, "friction", source, contact.line);
    }
    if (contact.gap <= 0) fail_at(source, contact.line, "a contact of yarns needs a gap");
    if (contact.friction_form != 2) fail_at(source, contact.line, "friction that sticks needs Iform 2");
  }
  for (const auto& [number, friction] : deck.frictions) {
    if (friction.formulation != 2) fail_at(source, friction.line, "friction that sticks needs Iform 2");
    for (const auto& [pair, value] : friction.of_pairs) {
      require_known(deck.parts, pair.first, "part", source, friction.line);
      require_known(deck.parts, pair.second, "part", source, friction.line);
    }
  }
}

bool node_is_held(const OpenRadiossDeck& deck, int node, std::size_t direction) {
  return std::ranges::any_of(deck.held,
                             [&](const auto& entry) { return holds(entry.second, deck.groups, node, direction); });
}

void check_velocity(const OpenRadiossDeck& deck, const OpenRadiossDeck::Velocity& velocity, const std::string& source) {
  require_known(deck.functions, velocity.function, "function", source, velocity.line);
  require_known(deck.groups, velocity.group, "node group", source, velocity.line);
  const auto direction = std::string("XYZ").find(velocity.direction);
  if (direction == std::string::npos || velocity.direction.size() != 1) {
    fail_at(source, velocity.line,
            fmt::format("a grip moves along X, Y or Z, not {}", base::in_quotes(velocity.direction)));
  }
  for (const int node : deck.groups.at(velocity.group).members) {
    if (!node_is_held(deck, node, direction)) continue;
    fail_at(source, velocity.line, fmt::format("the node {} is driven along {} and held", node, velocity.direction));
  }
}

void check_test(const OpenRadiossDeck& deck, const std::string& source) {
  for (const auto& [number, held] : deck.held) {
    require_known(deck.groups, held.group, "node group", source, held.line);
  }
  for (const auto& [number, velocity] : deck.velocities) check_velocity(deck, velocity, source);
  const auto held = [&](int node, std::size_t direction) { return node_is_held(deck, node, direction); };
  for (const auto& [number, constraint] : deck.constraints) {
    require_terms(constraint, number, deck.nodes, held, source);
  }
}

void check_histories(const OpenRadiossDeck& deck, const std::string& source) {
  for (const auto& [number, history] : deck.histories) {
    for (const int member : history.members) {
      if (history.kind == "NODE") require_known(deck.nodes, member, "node", source, history.line);
      if (history.kind == "PART") require_known(deck.parts, member, "part", source, history.line);
      if (history.kind == "INTER") require_known(deck.contacts, member, "interface", source, history.line);
    }
  }
}

}  // namespace

void check_openradioss(const OpenRadiossDeck& starter, const OpenRadiossEngine& engine, const std::string& source) {
  check_mesh(starter, source);
  check_contact(starter, source);
  check_test(starter, source);
  check_histories(starter, source);
  if (starter.run_name != engine.run_name) {
    fail_at(source, 1,
            fmt::format("the starter names the run {}, the engine {}", base::in_quotes(starter.run_name),
                        base::in_quotes(engine.run_name)));
  }
  if (starter.year != engine.year) {
    fail_at(source, 1, fmt::format("the starter is of {}, the engine of {}", starter.year, engine.year));
  }
}

}  // namespace knitmech::exchange
