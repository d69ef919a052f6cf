#include "model/toml_entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

// Debian's shared library holds the parser: the header-only one aborts on some wrong input where assertions are on.
#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>

#include "base/text.h"

namespace knitmech::model {
namespace {

constexpr std::size_t kLongestLine = 10000;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// A line of a text, counted from 1; empty if there is none.
std::string_view line_of(std::string_view text, int line) {
  for (int i = 1; i < line; ++i) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

void check_line_lengths(std::string_view text) {
  int line = 1;
  while (!text.empty()) {
    const auto length = std::min(text.find('\n'), text.size());
    if (length > kLongestLine) {
      throw TomlSyntaxError(line, fmt::format("the line is longer than {} letters; break it", kLongestLine));
    }
    text.remove_prefix(std::min(length + 1, text.size()));
    ++line;
  }
}

bool is_letter(char each) {
  return (each >= 'a' && each <= 'z') || (each >= 'A' && each <= 'Z');
}
bool is_digit(char each) {
  return each >= '0' && each <= '9';
}

/// What is usually meant by a line that is not TOML; empty if it shows none of the usual slips.
std::string usual_slip(std::string_view line) {
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) {
    return line.find(':') == std::string_view::npos ? "" : "write key = value, with an equals sign";
  }
  const auto key = trimmed(line.substr(0, equals));
  auto value = trimmed(line.substr(equals + 1));
  value = trimmed(value.substr(0, value.find('#')));
  if (key.empty()) return "write a key before the equals sign";
  if (value.empty()) return fmt::format("write a value after {} =", key);
  if (value.front() == '"' || value.front() == '\'' || value.front() == '[') return {};
  const bool numeric = is_digit(value.front()) || std::string_view("+-.").find(value.front()) != std::string_view::npos;
  if (numeric && value.find(',') != std::string_view::npos) return "write numbers with a decimal point";
  if (std::ranges::any_of(value, is_letter))
    return fmt::format("write {} = {} with quotes", key, base::in_quotes(value));
  return {};
}

/// What is wrong in a line that the parser refused, as one sentence without a full stop.
std::string syntax_complaint(const toml::parse_error& error, std::string_view text) {
  const auto line = line_of(text, static_cast<int>(error.source().begin.line));
  const std::string_view description = error.description();
  if (description.find("redefine") != std::string_view::npos) {
    return fmt::format("{} is there a second time; remove one of the two",
                       base::in_quotes(trimmed(line.substr(0, line.find('=')))));
  }
  const std::string slip = usual_slip(line);
  std::string complaint = fmt::format("{} is not valid TOML", base::in_quotes(trimmed(line)));
  return complaint + (slip.empty() ? fmt::format(" ({})", description) : "; " + slip);
}

toml::table parsed(std::string_view text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw TomlSyntaxError(static_cast<int>(error.source().begin.line), syntax_complaint(error, text));
  }
}

std::string type_in_words(toml::node_type type) {
  switch (type) {
    case toml::node_type::boolean:
      return "true or false";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::table:
      return "a section";
    default:
      return "a date or time";
  }
}

template <class Result>
Result plain_value(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* whole = node.as_integer()) return whole->get();
  if (const auto* number = node.as_floating_point()) return number->get();
  return TomlOther{type_in_words(node.type())};
}

TomlValue value_of(const toml::node& node) {
  const auto* list = node.as_array();
  if (list == nullptr) return plain_value<TomlValue>(node);
  std::vector<TomlItem> items;
  for (const toml::node& item : *list) items.push_back(plain_value<TomlItem>(item));
  return items;
}

std::string unambiguous(std::string_view part) {
  return part.find('.') == std::string_view::npos ? std::string(part) : base::in_quotes(part);
}

/// An entry and where it stands.
struct Placed {
  toml::source_position place;
  TomlEntry entry;
};

Placed placed(std::string key, const toml::key& where, TomlValue value) {
  const auto place = where.source().begin;
  return {place, {std::move(key), static_cast<int>(place.line), std::move(value)}};
}

bool begins_letter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

/// The byte at a place; its column counts letters, not bytes.
std::size_t offset_of(toml::source_position place, std::string_view text) {
  std::size_t offset = 0;
  for (toml::source_index line = 1; line < place.line; ++line) {
    const auto end = text.find('\n', offset);
    if (end == std::string_view::npos) return text.size();
    offset = end + 1;
  }
  for (toml::source_index column = 1; column < place.column && offset < text.size(); ++column) {
    do ++offset;
    while (offset < text.size() && !begins_letter(text[offset]));
  }
  return offset;
}

/// The entries of a table. \param prefix of its keys, "loop.", empty at the top. \param depth of sections below it
void collect(const toml::table& table, std::string_view text, const std::string& prefix, int depth,
             std::vector<Placed>& found) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + unambiguous(key.str());
    const auto* section = depth > 0 ? node.as_table() : nullptr;
    if (section == nullptr) {
      found.push_back(placed(name, key, value_of(node)));
      found.back().entry.begin = offset_of(node.source().begin, text);
      found.back().entry.end = offset_of(node.source().end, text);
    } else {
      found.push_back(placed(name, key, TomlSection{}));
      collect(*section, text, name + ".", depth - 1, found);
    }
  }
}

}  // namespace

std::vector<TomlEntry> toml_entries(std::string_view text, int depth) {
  check_line_lengths(text);
  std::vector<Placed> found;
  collect(parsed(text), text, "", depth, found);
  std::ranges::stable_sort(found, std::less<>(), &Placed::place);
  std::vector<TomlEntry> entries;
  entries.reserve(found.size());
  for (Placed& each : found) entries.push_back(std::move(each.entry));
  return entries;
}

}  // namespace knitmech::model
