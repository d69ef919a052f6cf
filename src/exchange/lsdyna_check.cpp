#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "exchange/constants.h"
#include "exchange/deck_references.h"
#include "exchange/lsdyna_reader.h"

namespace knitmech::exchange {

double LsDynaDeck::Curve::value(double x) const {
  return value_of_curve(points, x);
}

namespace {

constexpr int kPartSet = 2;

void check_mesh(const LsDynaDeck& deck, const std::string& source) {
  for (const auto& [number, part] : deck.parts) {
    require_known(deck.sections, part.section, "section", source, part.line);
    require_known(deck.materials, part.material, "material", source, part.line);
  }
  for (const auto& [number, section] : deck.sections) {
    if (section.formulation == kResultantBeam) continue;
    fail_at(source, section.line,
            fmt::format("ELFORM {} has other cards; a resultant beam is {}", section.formulation, kResultantBeam));
  }
  require_beams(deck, source);
  require_members(deck.groups, deck.nodes, "node", source);
  require_members(deck.part_groups, deck.parts, "part", source);
}

void check_contact(const LsDynaDeck& deck, const std::string& source) {
  for (const LsDynaDeck::Contact& contact : deck.contacts) {
    if (contact.group_kind != kPartSet) fail_at(source, contact.line, "the contact is not that of a part set, SSTYP 2");
    require_known(deck.part_groups, contact.group, "part set", source, contact.line);
    if (contact.friction == kFrictionOfTable) {
      require_known(deck.frictions, contact.friction_table, "friction", source, contact.line);
    }
  }
  for (const auto& [number, friction] : deck.frictions) {
    for (const auto& [pair, value] : friction.of_pairs) {
      require_known(deck.parts, pair.first, "part", source, friction.line);
      require_known(deck.parts, pair.second, "part", source, friction.line);
    }
  }
}

bool node_is_held(const LsDynaDeck& deck, int node, std::size_t direction) {
  return std::ranges::any_of(deck.held,
                             [&](const LsDynaDeck::Held& held) { return holds(held, deck.groups, node, direction); });
}

void check_motion(const LsDynaDeck& deck, const LsDynaDeck::Motion& motion, const std::string& source) {
  require_known(deck.groups, motion.group, "node set", source, motion.line);
  require_known(deck.curves, motion.curve, "curve", source, motion.line);
  if (motion.direction < 1 || motion.direction > 3 || motion.kind != 0) {
    fail_at(source, motion.line, "a grip moves with a velocity, VAD 0, along x, y or z, DOF 1 to 3");
  }
  for (const int node : deck.groups.at(motion.group).members) {
    if (!node_is_held(deck, node, static_cast<std::size_t>(motion.direction) - 1)) continue;
    fail_at(source, motion.line, fmt::format("the node {} is driven along {} and held", node, motion.direction));
  }
}

}  // namespace

void check_lsdyna(const LsDynaDeck& deck, const std::string& source) {
  check_mesh(deck, source);
  check_contact(deck, source);
  for (const LsDynaDeck::Held& held : deck.held) require_known(deck.groups, held.group, "node set", source, held.line);
  for (const LsDynaDeck::Motion& motion : deck.motions) check_motion(deck, motion, source);
  const auto held = [&](int node, std::size_t direction) { return node_is_held(deck, node, direction); };
  for (const auto& [number, constraint] : deck.constraints) {
    require_terms(constraint, number, deck.nodes, held, source);
  }
  for (const int group : deck.history_groups) {
    require_known(deck.groups, group, "node set", source, deck.histories_line);
  }
}

}  // namespace knitmech::exchange
