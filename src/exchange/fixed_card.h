#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knitmech::exchange {

/// A real number as text of at most `width` characters: the shortest one that gives back the same bits, or else as many
/// digits as fit, rounded. The exponent has no sign + and no leading zero, and where a digit is won by it the zero
/// before the point is left out: .011309734 in ten characters. Throws std::invalid_argument where not even one digit
/// fits.
/// @param value finite
[[nodiscard]] std::string number_within(double value, std::size_t width);

/// One line of a deck whose values stand in columns, each at the right end of its field.
class FixedCard {
 public:
  /// A whole number. Throws std::invalid_argument if it is longer than the field, as all of these do.
  FixedCard& whole(long long value, std::size_t width = 10);
  /// A real number, with as many digits as `characters` hold; 0: all of the field but one, so that a blank separates it
  /// from the field before.
  FixedCard& real(double value, std::size_t width = 20, std::size_t characters = 0);
  FixedCard& word(std::string_view text, std::size_t width = 10);
  FixedCard& blank(std::size_t width = 10);

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Whole numbers in fields of `width`, at most `per_line` on a line; each line ends with a line break.
[[nodiscard]] std::string cards_of_numbers(const std::vector<int>& numbers, std::size_t per_line,
                                           std::size_t width = 10);

/// A line cut into fields of given widths.
///
/// Reading is strict: what stands behind the last field is an error, and so is a field that holds anything but one
/// whole number, real number or word. An empty field is 0, as both programs take it.
class FixedFields {
 public:
  /// Throws InputError "source, line n: ..." for text behind the last field.
  FixedFields(std::string source, int line, std::string_view text, std::span<const std::size_t> widths);

  [[nodiscard]] bool blank(std::size_t field) const { return fields_.at(field).empty(); }
  /// \throws InputError if the field is no whole number
  [[nodiscard]] int whole(std::size_t field) const;
  /// \throws InputError if the field is no real number
  [[nodiscard]] double real(std::size_t field) const;
  /// The field without the blanks around it; those within it stay.
  [[nodiscard]] const std::string& word(std::size_t field) const { return fields_.at(field); }
  [[nodiscard]] int line() const { return line_; }

 private:
  std::string source_;
  int line_;
  std::vector<std::string> fields_;
};

}  // namespace knitmech::exchange
