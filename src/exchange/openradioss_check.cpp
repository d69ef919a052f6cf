#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "base/text.h"
#include "exchange/abaqus_lines.h"
#include "exchange/openradioss_reader.h"

namespace knitmech::exchange {

double OpenRadiossDeck::Function::value(double x) const {
  if (x <= points.front().first) return points.front().second;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto& [x_before, y_before] = points[i - 1];
    const auto& [x_after, y_after] = points[i];
    if (x <= x_after) return y_before + (y_after - y_before) * (x - x_before) / (x_after - x_before);
  }
  return points.back().second;
}

namespace {

/// Finds what a deck refers to and is not there.
class References {
 public:
  References(const OpenRadiossDeck& deck, const std::string& source) : deck_(deck), source_(source) {}

  template <typename Map>
  void require(const Map& known, int number, const char* what, int line) const {
    if (!known.contains(number)) fail_at(source_, line, fmt::format("the {} {} does not exist", what, number));
  }

  /// Every member of every group, none of which is empty.
  template <typename Map>
  void require_members(const std::map<int, OpenRadiossDeck::Group>& groups, const Map& known, const char* what) const {
    for (const auto& [number, group] : groups) {
      if (group.members.empty()) fail_at(source_, group.line, fmt::format("the group {} is empty", number));
      for (const int member : group.members) require(known, member, what, group.line);
    }
  }

  void check_mesh() const {
    for (const auto& [number, part] : deck_.parts) {
      require(deck_.properties, part.property, "property", part.line);
      require(deck_.materials, part.material, "material", part.line);
    }
    std::set<int> with_beams;
    for (const auto& [number, beam] : deck_.beams) {
      require(deck_.parts, beam.part, "part", beam.line);
      with_beams.insert(beam.part);
      for (const int node : beam.nodes) require(deck_.nodes, node, "node", beam.line);
      const auto& [first, last, third] = beam.nodes;
      if (first == last || first == third || last == third) {
        fail_at(source_, beam.line, fmt::format("the beam {} has a node twice", number));
      }
    }
    for (const auto& [number, part] : deck_.parts) {
      if (!with_beams.contains(number)) fail_at(source_, part.line, fmt::format("the part {} has no beams", number));
    }
    require_members(deck_.groups, deck_.nodes, "node");
    require_members(deck_.lines, deck_.parts, "part");
  }

  void check_contact() const {
    for (const auto& [number, contact] : deck_.contacts) {
      require(deck_.lines, contact.secondary, "line", contact.line);
      if (contact.main != 0) require(deck_.lines, contact.main, "line", contact.line);
      if (contact.friction_table != 0) require(deck_.frictions, contact.friction_table, "friction", contact.line);
      if (contact.gap <= 0) fail_at(source_, contact.line, "a contact of yarns needs a gap");
      if (contact.friction_form != 2) fail_at(source_, contact.line, "friction that sticks needs Iform 2");
    }
    for (const auto& [number, friction] : deck_.frictions) {
      if (friction.formulation != 2) fail_at(source_, friction.line, "friction that sticks needs Iform 2");
      for (const auto& [pair, value] : friction.of_pairs) {
        require(deck_.parts, pair.first, "part", friction.line);
        require(deck_.parts, pair.second, "part", friction.line);
      }
    }
  }

  void check_grips() const {
    for (const auto& [number, held] : deck_.held) require(deck_.groups, held.group, "node group", held.line);
    for (const auto& [number, velocity] : deck_.velocities) {
      require(deck_.functions, velocity.function, "function", velocity.line);
      require(deck_.groups, velocity.group, "node group", velocity.line);
      const auto direction = std::string("XYZ").find(velocity.direction);
      if (direction == std::string::npos || velocity.direction.size() != 1) {
        fail_at(source_, velocity.line,
                fmt::format("a grip moves along X, Y or Z, not {}", base::in_quotes(velocity.direction)));
      }
      for (const int node : deck_.groups.at(velocity.group).members) {
        if (is_held(node, direction)) {
          fail_at(source_, velocity.line,
                  fmt::format("the node {} is driven along {} and held", node, velocity.direction));
        }
      }
    }
  }

  void check_constraints() const {
    for (const auto& [number, constraint] : deck_.constraints) {
      if (constraint.terms.size() < 2) {
        fail_at(source_, constraint.line, fmt::format("the constraint {} has less than two terms", number));
      }
      for (const OpenRadiossDeck::Constraint::Term& term : constraint.terms) {
        require(deck_.nodes, term.node, "node", constraint.line);
        if (term.direction < 1 || term.direction > 6) {
          fail_at(source_, constraint.line, fmt::format("a direction is 1 to 6, not {}", term.direction));
        }
        if (is_held(term.node, static_cast<std::size_t>(term.direction) - 1)) {
          fail_at(source_, constraint.line, fmt::format("the node {} is constrained and held", term.node));
        }
      }
    }
  }

  void check_histories() const {
    for (const auto& [number, history] : deck_.histories) {
      for (const int member : history.members) {
        if (history.kind == "NODE") require(deck_.nodes, member, "node", history.line);
        if (history.kind == "PART") require(deck_.parts, member, "part", history.line);
        if (history.kind == "INTER") require(deck_.contacts, member, "interface", history.line);
      }
    }
  }

 private:
  [[nodiscard]] bool is_held(int node, std::size_t direction) const {
    return std::ranges::any_of(deck_.held, [&](const auto& entry) {
      const auto& [number, held] = entry;
      return held.directions.at(direction) &&
             std::ranges::find(deck_.groups.at(held.group).members, node) != deck_.groups.at(held.group).members.end();
    });
  }

  const OpenRadiossDeck& deck_;
  const std::string& source_;
};

}  // namespace

void check_openradioss(const OpenRadiossDeck& starter, const OpenRadiossEngine& engine, const std::string& source) {
  const References references(starter, source);
  references.check_mesh();
  references.check_contact();
  references.check_grips();
  references.check_constraints();
  references.check_histories();
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
