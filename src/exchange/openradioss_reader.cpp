#include "exchange/openradioss_reader.h"

#include <charconv>
#include <functional>
#include <istream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/abaqus_lines.h"
#include "exchange/openradioss_reading.h"

namespace knitmech::exchange {

namespace {

using radioss::path_of;
using radioss::Widths;

void read_begin(const CardBlock& block, OpenRadiossDeck& deck) {
  block.expect_lines(4);
  deck.run_name = block.at(0).text;
  deck.year = block.fields(1, Widths{10, 10}).whole(0);
  const FixedFields units = block.fields(2, Widths{20, 20, 20});
  for (std::size_t i = 0; i < 3; ++i) deck.units.at(i) = units.word(i);
}

void read_title(const CardBlock& block, OpenRadiossDeck& deck) {
  block.expect_lines(1);
  deck.title = block.at(0).text;
}

void pass_over(const CardBlock& /*block*/, OpenRadiossDeck& /*deck*/) {}

using Reader = void (*)(const CardBlock&, OpenRadiossDeck&);

/// By the words of a keyword, without its number.
const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> table{
      {"BEGIN", read_begin},
      {"TITLE", read_title},
      {"ANALY", pass_over},
      {"SPMD", pass_over},
      {"END", pass_over},
      {"MAT/ELAST", radioss::read_material},
      {"PROP/BEAM", radioss::read_property},
      {"PART", radioss::read_part},
      {"NODE", radioss::read_nodes},
      {"BEAM", radioss::read_beams},
      {"GRNOD/NODE", radioss::read_group},
      {"LINE/PART", radioss::read_lines},
      {"BCS", radioss::read_held},
      {"FUNCT", radioss::read_function},
      {"IMPVEL", radioss::read_velocity},
      {"MPC", radioss::read_constraint},
      {"FRICTION", radioss::read_friction},
      {"INTER/TYPE11", radioss::read_contact},
      {"TH/NODE", radioss::read_history},
      {"TH/PART", radioss::read_history},
      {"TH/INTER", radioss::read_history},
  };
  return table;
}

/// Words of a keyword up to the first number: "MAT/ELAST".
std::string words_of(const CardBlock& block) {
  std::string words;
  for (const std::string& part : path_of(block)) {
    if (!part.empty() && part.find_first_not_of("0123456789") == std::string::npos) break;
    words += (words.empty() ? "" : "/") + part;
  }
  return words;
}

/// The only line of an engine keyword, cut at its blanks, as numbers.
std::vector<double> numbers_of(const CardBlock& block, std::size_t n, const std::string& source) {
  block.expect_lines(1);
  std::vector<double> numbers;
  std::string_view rest = block.at(0).text;
  while (true) {
    const auto first = rest.find_first_not_of(' ');
    if (first == std::string_view::npos) break;
    rest.remove_prefix(first);
    const std::string_view word = rest.substr(0, rest.find(' '));
    numbers.push_back(real_number(source, block.at(0).number, std::string(word)));
    rest.remove_prefix(word.size());
  }
  if (numbers.size() != n) block.fail(fmt::format("{} needs {} numbers", block.keyword(), n));
  return numbers;
}

void read_engine_block(const CardBlock& block, const std::string& source, OpenRadiossEngine& engine) {
  const std::vector<std::string> path = path_of(block);
  const std::string words = words_of(block);
  if (path.front() == "RUN" && path.size() == 3) {
    engine.run_name = path[1];
    engine.run = radioss::number_of(block);
    engine.end_time = numbers_of(block, 1, source)[0];
  } else if (words == "VERS") {
    engine.year = radioss::number_of(block);
  } else if (words == "TFILE") {
    engine.history_interval = numbers_of(block, 1, source)[0];
  } else if (words == "ANIM/DT") {
    const std::vector<double> times = numbers_of(block, 2, source);
    engine.first_picture = times[0];
    engine.picture_interval = times[1];
  } else if (words.starts_with("ANIM/VECT/")) {
    engine.vectors.push_back(path.back());
  } else if (words == "DT") {
    const std::vector<double> step = numbers_of(block, 2, source);
    engine.step_share = step[0];
    engine.least_step = step[1];
  } else if (!words.starts_with("PRINT")) {
    engine.unread.push_back({block.keyword(), block.line()});
  }
}

}  // namespace

namespace radioss {

std::vector<std::string> path_of(const CardBlock& block) {
  std::vector<std::string> path;
  std::string_view rest = std::string_view(block.keyword()).substr(1);
  while (true) {
    const auto slash = rest.find('/');
    path.emplace_back(rest.substr(0, slash));
    if (slash == std::string_view::npos) return path;
    rest.remove_prefix(slash + 1);
  }
}

int number_of(const CardBlock& block) {
  const std::string last = path_of(block).back();
  int number = 0;
  const auto [end, error] = std::from_chars(last.data(), last.data() + last.size(), number);
  if (error != std::errc() || end != last.data() + last.size()) {
    block.fail(fmt::format("{} needs a number at its end", block.keyword()));
  }
  return number;
}

}  // namespace radioss

OpenRadiossDeck read_openradioss_starter(std::istream& in, const std::string& source) {
  OpenRadiossDeck deck;
  const std::vector<CardBlock> blocks = read_card_blocks(in, source, '/', '#');
  for (const CardBlock& block : blocks) {
    const auto reader = readers().find(words_of(block));
    if (reader == readers().end()) {
      deck.unread.push_back({block.keyword(), block.line()});
    } else {
      reader->second(block, deck);
    }
  }
  if (blocks.back().keyword() != "/END") blocks.back().fail("the deck does not end with /END");
  return deck;
}

OpenRadiossEngine read_openradioss_engine(std::istream& in, const std::string& source) {
  OpenRadiossEngine engine;
  for (const CardBlock& block : read_card_blocks(in, source, '/', '#')) read_engine_block(block, source, engine);
  return engine;
}

}  // namespace knitmech::exchange
