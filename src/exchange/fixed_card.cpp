#include "exchange/fixed_card.h"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "base/text.h"
#include "exchange/abaqus_lines.h"

namespace knitmech::exchange {

namespace {

/// 1.2e-05 as 1.2e-5, 1e+07 as 1e7.
std::string with_short_exponent(const std::string& text) {
  const auto e = text.find('e');
  if (e == std::string::npos) return text;
  return fmt::format("{}e{}", text.substr(0, e), std::atoi(text.c_str() + e + 1));
}

/// 0.12 as .12, -0.12 as -.12.
std::string without_leading_zero(const std::string& text) {
  if (text.starts_with("0.")) return text.substr(1);
  return text.starts_with("-0.") ? "-" + text.substr(2) : text;
}

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

}  // namespace

std::string number_within(double value, std::size_t width) {
  std::string text = with_short_exponent(fmt::format("{}", value));
  for (int digits = 16; text.size() > width && digits > 0; --digits) {
    text = with_short_exponent(fmt::format("{:.{}g}", value, digits));
    if (text.size() > width) text = without_leading_zero(text);
  }
  if (text.size() > width) {
    throw std::invalid_argument(fmt::format("number_within: {} does not fit into {} characters", value, width));
  }
  return text;
}

FixedCard& FixedCard::word(std::string_view text, std::size_t width) {
  if (text.size() > width) {
    throw std::invalid_argument(fmt::format("FixedCard: \"{}\" does not fit into {} characters", text, width));
  }
  text_ += fmt::format("{:>{}}", text, width);
  return *this;
}

FixedCard& FixedCard::whole(long long value, std::size_t width) {
  return word(std::to_string(value), width);
}

FixedCard& FixedCard::real(double value, std::size_t width, std::size_t characters) {
  return word(number_within(value, characters == 0 ? width - 1 : characters), width);
}

FixedCard& FixedCard::blank(std::size_t width) {
  return word("", width);
}

std::string cards_of_numbers(const std::vector<int>& numbers, std::size_t per_line, std::size_t width) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += fmt::format("{:>{}}", numbers[i], width);
    if (i + 1 == numbers.size() || (i + 1) % per_line == 0) text += '\n';
  }
  return text;
}

FixedFields::FixedFields(std::string source, int line, std::string_view text, std::span<const std::size_t> widths)
    : source_(std::move(source)), line_(line) {
  std::size_t at = 0;
  for (const std::size_t width : widths) {
    fields_.push_back(at < text.size() ? trimmed(text.substr(at, width)) : "");
    at += width;
  }
  if (at >= text.size()) return;
  const std::string rest = trimmed(text.substr(at));
  if (!rest.empty()) {
    fail_at(source_, line_, fmt::format("{} stands behind column {}, where this card ends", base::in_quotes(rest), at));
  }
}

int FixedFields::whole(std::size_t field) const {
  return blank(field) ? 0 : integer(source_, line_, fields_[field]);
}

double FixedFields::real(std::size_t field) const {
  return real_number(source_, line_, fields_.at(field));
}

}  // namespace knitmech::exchange
