#pragma once

#include <cstddef>
#include <iosfwd>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "exchange/fixed_card.h"

namespace knitmech::exchange {

/// A keyword of a deck with the lines behind it, of a format whose keywords begin with one mark and whose comments
/// begin with another: / and # in OpenRadioss, * and $ in LS-DYNA.
class CardBlock {
 public:
  struct Line {
    int number = 0;  ///< from 1
    std::string text;
  };

  CardBlock(std::string source, std::string keyword, int line)
      : source_(std::move(source)), keyword_(std::move(keyword)), line_(line) {}
  void add(Line line) { lines_.push_back(std::move(line)); }

  [[nodiscard]] const std::string& keyword() const { return keyword_; }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] std::size_t size() const { return lines_.size(); }

  /// Line i as it stands. Throws InputError if there is none.
  [[nodiscard]] const Line& at(std::size_t i) const;
  /// Line i cut into fields. Throws InputError if there is none, and as FixedFields does.
  [[nodiscard]] FixedFields fields(std::size_t i, std::span<const std::size_t> widths) const;
  /// All whole numbers from line i on, at most `per_line` on each, in fields of ten columns; empty fields are passed
  /// over.
  [[nodiscard]] std::vector<int> numbers_from(std::size_t i, std::size_t per_line) const;

  /// Throws InputError for another number of lines.
  void expect_lines(std::size_t n) const;
  /// Throws InputError "source, line n: message" with the line of the keyword.
  [[noreturn]] void fail(const std::string& message) const;

 private:
  std::string source_;
  std::string keyword_;
  int line_;
  std::vector<Line> lines_;
};

/// Cuts a deck into keywords, without its comments. Keywords have no blanks at their end.
/// Throws InputError for a line before the first keyword that is no comment, and for a deck without any.
[[nodiscard]] std::vector<CardBlock> read_card_blocks(std::istream& in, const std::string& source, char keyword_mark,
                                                      char comment_mark);

}  // namespace knitmech::exchange
