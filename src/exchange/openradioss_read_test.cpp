#include <string>

#include "exchange/constants.h"
#include "exchange/openradioss_reading.h"

// Columns: Radioss Reference Guide, "Starter Input", the page of each keyword.

namespace knitmech::exchange::radioss {

void read_held(const CardBlock& block, OpenRadiossDeck& deck) {
  block.expect_lines(2);
  const FixedFields card = block.fields(1, Widths{10, 10, 10});
  const std::string& code = card.word(0);
  if (code.size() != 7 || code[3] != ' ' || code.find_first_not_of("01 ") != std::string::npos) {
    block.fail(fmt::format("the code of /BCS is three digits 0 or 1, a blank and three more, not {}", code));
  }
  OpenRadiossDeck::Held& held = new_entry(deck.held, number_of(block), block);
  for (std::size_t i = 0; i < 6; ++i) held.directions.at(i) = code[i < 3 ? i : i + 1] == '1';
  held.group = card.whole(2);
  held.line = block.line();
}

void read_function(const CardBlock& block, OpenRadiossDeck& deck) {
  if (block.size() < 2) block.fail(fmt::format("{} has no points", block.keyword()));
  OpenRadiossDeck::Function& function = new_entry(deck.functions, number_of(block), block);
  function.line = block.line();
  for (std::size_t i = 1; i < block.size(); ++i) {
    const FixedFields card = block.fields(i, Widths{20, 20});
    function.points.emplace_back(card.real(0), card.real(1));
  }
}

void read_velocity(const CardBlock& block, OpenRadiossDeck& deck) {
  block.expect_lines(3);
  const FixedFields what = block.fields(1, Widths{10, 10, 10, 10, 10, 10, 10});
  const FixedFields scale = block.fields(2, Widths{20, 20, 20, 20});
  new_entry(deck.velocities, number_of(block), block) = {what.whole(0), what.word(1),  what.whole(4),
                                                         scale.real(0), scale.real(1), block.line()};
}

void read_constraint(const CardBlock& block, OpenRadiossDeck& deck) {
  OpenRadiossDeck::Constraint& constraint = new_entry(deck.constraints, number_of(block), block);
  constraint.line = block.line();
  for (std::size_t i = 1; i < block.size(); ++i) {
    const FixedFields card = block.fields(i, Widths{10, 10, 10, 20});
    constraint.terms.push_back({card.whole(0), card.whole(1), card.real(3)});
  }
}

void read_friction(const CardBlock& block, OpenRadiossDeck& deck) {
  const Widths coefficients{20, 20, 20};
  OpenRadiossDeck::Friction& friction = new_entry(deck.frictions, number_of(block), block);
  friction.formulation = block.fields(1, Widths{10, 10, 20, 10}).whole(3);
  friction.of_all = block.fields(3, coefficients).real(1);
  friction.line = block.line();
  for (std::size_t i = 4; i < block.size(); i += 3) {
    const FixedFields parts = block.fields(i, Widths{10, 10, 10, 10});
    friction.of_pairs[{parts.whole(2), parts.whole(3)}] = block.fields(i + 2, coefficients).real(1);
  }
}

void read_contact(const CardBlock& block, OpenRadiossDeck& deck) {
  block.expect_lines(6);
  const bool has_removed_gap = deck.year >= kRadiossYearOfRemovedGaps;
  const FixedFields flags = block.fields(1, Widths{10, 10, 10, 10, 10, 10, 10, 10});
  const FixedFields limits = block.fields(2, Widths{20, 20, 20, 20, 10, 10});
  const FixedFields values = block.fields(3, Widths{20, 20, 20, 20, 20});
  if (!flags.blank(6) && !has_removed_gap) {
    block.fail(fmt::format("/INTER/TYPE11 has no Irem_gap in the format of {}", deck.year));
  }
  new_entry(deck.contacts, number_of(block), block) = {
      .secondary = flags.whole(0),
      .main = flags.whole(1),
      .stiffness_flag = flags.whole(2),
      .gap_flag = flags.whole(4),
      .removed_gap = flags.whole(6),
      .friction_form = limits.whole(4),
      .stiffness = values.real(0),
      .friction = values.real(1),
      .gap = values.real(2),
      .friction_table = block.fields(5, Widths{90, 10}).whole(1),
      .line = block.line(),
  };
  (void)block.fields(4, Widths{10, 20, 10, 20, 20, 20}).whole(2);
}

void read_history(const CardBlock& block, OpenRadiossDeck& deck) {
  OpenRadiossDeck::History& history = new_entry(deck.histories, number_of(block), block);
  history.kind = path_of(block).at(1);
  history.line = block.line();
  const FixedFields variables = block.fields(1, Widths(10, 10));
  for (std::size_t i = 0; i < 10; ++i) {
    if (!variables.blank(i)) history.variables.push_back(variables.word(i));
  }
  if (history.kind != "NODE") {
    history.members = block.numbers_from(2, kNumbersOnALine);
    return;
  }
  for (std::size_t i = 2; i < block.size(); ++i) {
    history.members.push_back(block.fields(i, Widths{10, 10, 80}).whole(0));
  }
}

}  // namespace knitmech::exchange::radioss
