#include <string>
#include <vector>

#include "exchange/constants.h"
#include "exchange/openradioss_reading.h"

// Columns: Radioss Reference Guide, "Starter Input", the page of each keyword.

namespace knitmech::exchange::radioss {

void read_material(const CardBlock& block, OpenRadiossDeck& deck) {
  block.expect_lines(3);
  const FixedFields elastic = block.fields(2, Widths{20, 20});
  new_entry(deck.materials, number_of(block), block) = {block.fields(1, Widths{20}).real(0), elastic.real(0),
                                                        elastic.real(1), block.line()};
}

void read_property(const CardBlock& block, OpenRadiossDeck& deck) {
  block.expect_lines(5);
  const FixedFields section = block.fields(3, Widths{20, 20, 20, 20});
  const FixedFields hinges = block.fields(4, Widths{10, 10});
  if (hinges.word(0) != "000 000") block.fail("a beam of a yarn has no hinges: 000 000");
  new_entry(deck.properties, number_of(block), block) = {section.real(0), section.real(1),      section.real(2),
                                                         section.real(3), hinges.whole(1) == 0, block.line()};
}

void read_part(const CardBlock& block, OpenRadiossDeck& deck) {
  block.expect_lines(2);
  const FixedFields card = block.fields(1, Widths{10, 10, 10, 20});
  new_entry(deck.parts, number_of(block), block) = {card.whole(0), card.whole(1), card.real(3), block.line()};
}

void read_nodes(const CardBlock& block, OpenRadiossDeck& deck) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    const FixedFields card = block.fields(i, Widths{10, 20, 20, 20});
    new_entry(deck.nodes, card.whole(0), block) = {card.real(1), card.real(2), card.real(3)};
  }
}

void read_beams(const CardBlock& block, OpenRadiossDeck& deck) {
  const int part = number_of(block);
  for (std::size_t i = 0; i < block.size(); ++i) {
    const FixedFields card = block.fields(i, Widths{10, 10, 10, 10});
    new_entry(deck.beams, card.whole(0), block) = {
        part, {card.whole(1), card.whole(2), card.whole(3)}, block.at(i).number};
  }
}

void read_group(const CardBlock& block, OpenRadiossDeck& deck) {
  new_entry(deck.groups, number_of(block), block) = {block.at(0).text, block.numbers_from(1, kNumbersOnALine),
                                                     block.line()};
}

void read_lines(const CardBlock& block, OpenRadiossDeck& deck) {
  new_entry(deck.lines, number_of(block), block) = {block.at(0).text, block.numbers_from(1, kNumbersOnALine),
                                                    block.line()};
}

}  // namespace knitmech::exchange::radioss
