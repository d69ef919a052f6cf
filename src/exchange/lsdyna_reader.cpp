#include "exchange/lsdyna_reader.h"

#include <fmt/format.h>

#include <istream>
#include <map>
#include <string>
#include <vector>

#include "exchange/card_blocks.h"
#include "exchange/constants.h"
#include "exchange/deck_references.h"

// Columns: LS-DYNA Keyword User's Manual I and II, the page of each keyword.

namespace knitmech::exchange {

namespace {

using Widths = std::vector<std::size_t>;

const Widths kTens(8, 10);
const Widths kEights(10, 8);

template <typename Map>
auto& new_entry(Map& map, int number, const CardBlock& block) {
  const auto [entry, is_new] = map.try_emplace(number);
  if (!is_new) block.fail(fmt::format("{} defines the number {} a second time", block.keyword(), number));
  return entry->second;
}

void read_title(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(1);
  deck.title = block.at(0).text;
}

void read_units(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(1);
  const FixedFields card = block.fields(0, kTens);
  for (std::size_t i = 0; i < 3; ++i) deck.units.at(i) = card.word(i);
}

void read_termination(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(1);
  deck.end_time = block.fields(0, kTens).real(0);
}

void read_time_step(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(1);
  deck.step_share = block.fields(0, kTens).real(1);
}

void read_interval(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(1);
  deck.intervals[block.keyword().substr(std::string("*DATABASE_").size())] = block.fields(0, kTens).real(0);
}

void read_histories(const CardBlock& block, LsDynaDeck& deck) {
  deck.history_groups = block.numbers_from(0, kDynaNumbersOnALine);
  deck.histories_line = block.line();
}

void read_part(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(2);
  const FixedFields card = block.fields(1, kTens);
  new_entry(deck.parts, card.whole(0), block) = {block.at(0).text, card.whole(1), card.whole(2), block.line()};
}

void read_section(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(2);
  const FixedFields kind = block.fields(0, kTens), values = block.fields(1, kTens);
  new_entry(deck.sections, kind.whole(0), block) = {kind.whole(1),  values.real(0), values.real(1), values.real(2),
                                                    values.real(3), values.real(4), block.line()};
}

void read_material(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(1);
  const FixedFields card = block.fields(0, kTens);
  new_entry(deck.materials, card.whole(0), block) = {card.real(1), card.real(2), card.real(3), block.line()};
}

void read_nodes(const CardBlock& block, LsDynaDeck& deck) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    const FixedFields card = block.fields(i, Widths{8, 16, 16, 16, 8, 8});
    new_entry(deck.nodes, card.whole(0), block) = {card.real(1), card.real(2), card.real(3)};
  }
}

void read_beams(const CardBlock& block, LsDynaDeck& deck) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    const FixedFields card = block.fields(i, kEights);
    new_entry(deck.beams, card.whole(0), block) = {
        card.whole(1), {card.whole(2), card.whole(3), card.whole(4)}, block.at(i).number};
  }
}

void read_node_set(const CardBlock& block, LsDynaDeck& deck) {
  new_entry(deck.groups, block.fields(0, kTens).whole(0), block) = {block.numbers_from(1, kDynaNumbersOnALine),
                                                                    block.line()};
}

void read_part_set(const CardBlock& block, LsDynaDeck& deck) {
  new_entry(deck.part_groups, block.fields(0, kTens).whole(0), block) = {block.numbers_from(1, kDynaNumbersOnALine),
                                                                         block.line()};
}

void read_held(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(1);
  const FixedFields card = block.fields(0, kTens);
  LsDynaDeck::Held held{.group = card.whole(0), .line = block.line()};
  for (std::size_t i = 0; i < 6; ++i) {
    const int code = card.whole(i + 2);
    if (code != 0 && code != 1) block.fail(fmt::format("a direction is held, 1, or not, 0, and not {}", code));
    held.directions.at(i) = code == 1;
  }
  deck.held.push_back(held);
}

void read_curve(const CardBlock& block, LsDynaDeck& deck) {
  if (block.size() < 2) block.fail("a curve has one point or more");
  LsDynaDeck::Curve& curve = new_entry(deck.curves, block.fields(0, kTens).whole(0), block);
  curve.line = block.line();
  for (std::size_t i = 1; i < block.size(); ++i) {
    const FixedFields card = block.fields(i, Widths{20, 20});
    curve.points.emplace_back(card.real(0), card.real(1));
  }
}

void read_motion(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(1);
  const FixedFields card = block.fields(0, kTens);
  deck.motions.push_back({card.whole(0), card.whole(1), card.whole(2), card.whole(3), card.real(4), block.line()});
}

void read_friction(const CardBlock& block, LsDynaDeck& deck) {
  const FixedFields of_all = block.fields(0, kTens);
  LsDynaDeck::Friction& friction = new_entry(deck.frictions, of_all.whole(0), block);
  friction.of_all = of_all.real(1);
  friction.line = block.line();
  const auto require_same = [&](const FixedFields& card, std::size_t first) {
    if (card.real(first) != card.real(first + 1)) block.fail("static and dynamic friction differ");
  };
  require_same(of_all, 1);
  for (std::size_t i = 1; i < block.size(); ++i) {
    const FixedFields card = block.fields(i, kTens);
    require_same(card, 2);
    friction.of_pairs[{card.whole(0), card.whole(1)}] = card.real(2);
  }
}

void read_contact(const CardBlock& block, LsDynaDeck& deck) {
  block.expect_lines(5);
  const FixedFields group = block.fields(1, kTens), friction = block.fields(2, kTens), scale = block.fields(3, kTens);
  LsDynaDeck::Contact contact{.group = group.whole(0), .group_kind = group.whole(2), .line = block.line()};
  contact.friction = friction.real(0);
  if (contact.friction == kFrictionOfTable) contact.friction_table = friction.whole(1);
  contact.stiffness_scale = scale.real(0);
  contact.thickness = scale.real(2);
  if (scale.real(1) != contact.stiffness_scale || scale.real(3) != contact.thickness) {
    block.fail("a contact of all yarns with themselves has SFS = SFM and SST = MST");
  }
  contact.soft = block.fields(4, kTens).whole(0);
  deck.contacts.push_back(contact);
}

void read_constraint(const CardBlock& block, LsDynaDeck& deck) {
  LsDynaDeck::Constraint& constraint = new_entry(deck.constraints, block.fields(0, kTens).whole(0), block);
  constraint.line = block.line();
  for (std::size_t i = 1; i < block.size(); ++i) {
    const FixedFields card = block.fields(i, Widths{10, 10, 10});
    constraint.terms.push_back({card.whole(0), card.whole(1), card.real(2)});
  }
}

void pass_over(const CardBlock& /*block*/, LsDynaDeck& /*deck*/) {}

using Reader = void (*)(const CardBlock&, LsDynaDeck&);

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> table{
      {"*KEYWORD", pass_over},
      {"*END", pass_over},
      {"*TITLE", read_title},
      {"*CONTROL_UNITS", read_units},
      {"*CONTROL_TERMINATION", read_termination},
      {"*CONTROL_TIMESTEP", read_time_step},
      {"*CONTROL_ENERGY", pass_over},
      {"*DATABASE_GLSTAT", read_interval},
      {"*DATABASE_MATSUM", read_interval},
      {"*DATABASE_BNDOUT", read_interval},
      {"*DATABASE_SPCFORC", read_interval},
      {"*DATABASE_NODOUT", read_interval},
      {"*DATABASE_BINARY_D3PLOT", read_interval},
      {"*DATABASE_HISTORY_NODE_SET", read_histories},
      {"*PART", read_part},
      {"*SECTION_BEAM", read_section},
      {"*MAT_ELASTIC", read_material},
      {"*NODE", read_nodes},
      {"*ELEMENT_BEAM", read_beams},
      {"*SET_NODE_LIST", read_node_set},
      {"*SET_PART_LIST", read_part_set},
      {"*BOUNDARY_SPC_SET", read_held},
      {"*DEFINE_CURVE", read_curve},
      {"*BOUNDARY_PRESCRIBED_MOTION_SET", read_motion},
      {"*DEFINE_FRICTION", read_friction},
      {"*CONTACT_AUTOMATIC_GENERAL_ID", read_contact},
      {"*CONSTRAINED_LINEAR_GLOBAL", read_constraint},
  };
  return table;
}

}  // namespace

LsDynaDeck read_lsdyna(std::istream& in, const std::string& source) {
  LsDynaDeck deck;
  const std::vector<CardBlock> blocks = read_card_blocks(in, source, '*', '$');
  for (const CardBlock& block : blocks) {
    const auto reader = readers().find(block.keyword());
    if (reader == readers().end()) {
      deck.unread.push_back({block.keyword(), block.line()});
    } else {
      reader->second(block, deck);
    }
  }
  if (blocks.front().keyword() != "*KEYWORD") blocks.front().fail("the deck does not begin with *KEYWORD");
  if (blocks.back().keyword() != "*END") blocks.back().fail("the deck does not end with *END");
  return deck;
}

}  // namespace knitmech::exchange
