#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "exchange/card_blocks.h"
#include "exchange/openradioss_deck.h"

/// The parts of the reader of OpenRadioss decks, for openradioss_read*.cpp alone.
namespace knitmech::exchange::radioss {

using Widths = std::vector<std::size_t>;

/// "/MAT/ELAST/1" as MAT, ELAST, 1.
[[nodiscard]] std::vector<std::string> path_of(const CardBlock& block);
/// The number at the end of a keyword. Throws InputError if there is none.
[[nodiscard]] int number_of(const CardBlock& block);

/// A new entry of a map. Throws InputError if the number has one already.
template <typename Map>
auto& new_entry(Map& map, int number, const CardBlock& block) {
  const auto [entry, is_new] = map.try_emplace(number);
  if (!is_new) block.fail(fmt::format("{} defines the number {} a second time", block.keyword(), number));
  return entry->second;
}

void read_material(const CardBlock& block, OpenRadiossDeck& deck);
void read_property(const CardBlock& block, OpenRadiossDeck& deck);
void read_part(const CardBlock& block, OpenRadiossDeck& deck);
void read_nodes(const CardBlock& block, OpenRadiossDeck& deck);
void read_beams(const CardBlock& block, OpenRadiossDeck& deck);
void read_group(const CardBlock& block, OpenRadiossDeck& deck);
void read_lines(const CardBlock& block, OpenRadiossDeck& deck);

void read_held(const CardBlock& block, OpenRadiossDeck& deck);
void read_function(const CardBlock& block, OpenRadiossDeck& deck);
void read_velocity(const CardBlock& block, OpenRadiossDeck& deck);
void read_constraint(const CardBlock& block, OpenRadiossDeck& deck);
void read_friction(const CardBlock& block, OpenRadiossDeck& deck);
void read_contact(const CardBlock& block, OpenRadiossDeck& deck);
void read_history(const CardBlock& block, OpenRadiossDeck& deck);

}  // namespace knitmech::exchange::radioss
