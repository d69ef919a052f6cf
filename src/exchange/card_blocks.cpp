#include "exchange/card_blocks.h"

#include <fmt/format.h>

#include <istream>

#include "base/errors.h"
#include "base/text.h"
#include "exchange/abaqus_lines.h"

namespace knitmech::exchange {

const CardBlock::Line& CardBlock::at(std::size_t i) const {
  if (i >= lines_.size()) fail(fmt::format("{} ends before its line {}", keyword_, i + 1));
  return lines_[i];
}

FixedFields CardBlock::fields(std::size_t i, std::span<const std::size_t> widths) const {
  const Line& line = at(i);
  return {source_, line.number, line.text, widths};
}

std::vector<int> CardBlock::numbers_from(std::size_t i, std::size_t per_line) const {
  const std::vector<std::size_t> widths(per_line, 10);
  std::vector<int> numbers;
  for (; i < lines_.size(); ++i) {
    const FixedFields card = fields(i, widths);
    for (std::size_t k = 0; k < per_line; ++k) {
      if (!card.blank(k)) numbers.push_back(card.whole(k));
    }
  }
  return numbers;
}

void CardBlock::expect_lines(std::size_t n) const {
  if (lines_.size() != n) fail(fmt::format("{} has {} lines here and needs {}", keyword_, lines_.size(), n));
}

void CardBlock::fail(const std::string& message) const {
  fail_at(source_, line_, message);
}

std::vector<CardBlock> read_card_blocks(std::istream& in, const std::string& source, char keyword_mark,
                                        char comment_mark) {
  std::vector<CardBlock> blocks;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    if (text.ends_with('\r')) text.pop_back();
    if (text.starts_with(comment_mark)) continue;
    if (text.starts_with(keyword_mark)) {
      blocks.emplace_back(source, text.substr(0, text.find_last_not_of(" \t") + 1), line);
    } else if (!blocks.empty()) {
      blocks.back().add({line, text});
    } else if (text.find_first_not_of(" \t") != std::string::npos) {
      fail_at(source, line, fmt::format("{} stands before the first keyword", base::in_quotes(text)));
    }
  }
  if (blocks.empty()) throw InputError(fmt::format("{}: no keyword in it", source));
  return blocks;
}

}  // namespace knitmech::exchange
