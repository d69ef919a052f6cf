#include "model/edit_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "base/errors.h"
#include "base/quantity.h"
#include "base/text.h"
#include "model/parameters_text.h"

namespace knitmech::model {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text, std::string_view letters = kBlanks) {
  const auto first = text.find_first_not_of(letters);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(letters) - first + 1);
}

std::string typed_item(const TomlItem& item) {
  if (const auto* text = std::get_if<std::string>(&item)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&item)) return fmt::format("{}", *whole);
  if (const auto* number = std::get_if<double>(&item)) return fmt::format("{}", *number);
  return std::get<TomlOther>(item).type;
}

/// A text that is a finite number from end to end, as TOML writes numbers; empty for any other.
std::optional<std::string> number_in(std::string_view typed) {
  double value = 0;
  const char* const end = typed.data() + typed.size();
  const auto [stop, error] = std::from_chars(typed.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  // TOML has no ".5", "5." and "05"; those are written anew.
  const bool is_whole = typed.find_first_not_of("-0123456789") == std::string_view::npos;
  return is_whole ? fmt::format("{:.0f}", value) : fmt::format("{}", value);
}

std::vector<std::string_view> items_of(std::string_view typed, std::string_view separators) {
  std::vector<std::string_view> items;
  typed = trimmed(typed, " \t\r\n[]");
  while (!typed.empty()) {
    const auto end = std::min(typed.find_first_of(separators), typed.size());
    const auto item = trimmed(typed.substr(0, end), " \t\r\n\"");
    if (!item.empty()) items.push_back(item);
    typed.remove_prefix(std::min(end + 1, typed.size()));
  }
  return items;
}

std::string list_of_typed(const Parameter& parameter, std::string_view typed) {
  const bool has_unit = parameter.dimension != base::Dimension::number;
  std::string list;
  for (const std::string_view item : items_of(typed, has_unit ? "," : ", \t\r\n")) {
    const auto number = has_unit ? std::nullopt : number_in(item);
    list += fmt::format("{}{}", list.empty() ? "" : ", ", number ? *number : toml_string(item));
  }
  return "[" + list + "]";
}

const TomlEntry* find_entry(const std::vector<TomlEntry>& entries, std::string_view key) {
  const auto found = std::ranges::find(entries, key, &TomlEntry::key);
  return found == entries.end() ? nullptr : &*found;
}

std::vector<TomlEntry> entries_of(std::string_view text) {
  try {
    return toml_entries(text);
  } catch (const TomlSyntaxError& error) {
    throw InputError(fmt::format("line {} of the case file must be mended first: {}", error.line(), error.what()));
  }
}

std::size_t start_of_line(std::string_view text, std::size_t place) {
  if (place == 0) return 0;
  const auto before = text.rfind('\n', place - 1);
  return before == std::string_view::npos ? 0 : before + 1;
}

std::size_t start_of_next_line(std::string_view text, std::size_t place) {
  const auto end = text.find('\n', place);
  return end == std::string_view::npos ? text.size() : end + 1;
}

std::size_t start_of_line_number(std::string_view text, int line) {
  std::size_t place = 0;
  for (int i = 1; i < line; ++i) place = start_of_next_line(text, place);
  return place;
}

std::string commented_out(std::string_view text, const TomlEntry& entry) {
  std::string result(text);
  const std::size_t first = start_of_line_number(text, entry.line);
  std::size_t line = start_of_line(text, entry.end == 0 ? 0 : entry.end - 1);
  for (;; line = start_of_line(text, line - 1)) {
    result.insert(line, "# ");
    if (line <= first) break;
  }
  return result;
}

/// A line of a section that holds the place of a key: # name = value.
struct HeldPlace {
  std::size_t hash;        ///< the place of its #
  std::size_t value, end;  ///< of what stands for the value
};

/// Where the lines of a section begin and end; those without a section end with the first one.
struct Lines {
  std::size_t begin, end;
};

std::optional<Lines> lines_of_section(std::string_view text, std::string_view section) {
  std::optional<Lines> lines;
  if (section.empty()) lines = Lines{0, text.size()};
  const std::string head = fmt::format("[{}]", section);
  for (std::size_t place = 0; place < text.size(); place = start_of_next_line(text, place)) {
    const auto line = trimmed(text.substr(place, start_of_next_line(text, place) - place));
    const bool is_head = !line.empty() && line.front() == '[';
    if (is_head && lines) {
      lines->end = place;
      break;
    }
    if (is_head && line.starts_with(head)) lines = Lines{start_of_next_line(text, place), text.size()};
  }
  return lines;
}

std::optional<HeldPlace> held_place(std::string_view text, Lines lines, std::string_view name) {
  for (std::size_t place = lines.begin; place < lines.end; place = start_of_next_line(text, place)) {
    const std::string_view line = text.substr(place, start_of_next_line(text, place) - place);
    const auto hash = line.find_first_not_of(" \t");
    if (hash == std::string_view::npos || line[hash] != '#') continue;
    const auto equals = line.find('=', hash);
    if (equals == std::string_view::npos || trimmed(line.substr(hash + 1, equals - hash - 1)) != name) continue;
    // The value ends where the comment behind it begins, outside of quotes.
    bool quoted = false;
    std::size_t end = equals + 1;
    for (; end < line.size() && line[end] != '\n' && (quoted || line[end] != '#'); ++end) {
      quoted = quoted != (line[end] == '"');
    }
    const auto value = line.substr(equals + 1, end - equals - 1);
    const auto first = value.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return HeldPlace{place + hash, place + equals + 1, place + equals + 1};
    const auto start = place + equals + 1 + first;
    return HeldPlace{place + hash, start, start + trimmed(value).size()};
  }
  return std::nullopt;
}

std::string with_place_taken(std::string_view text, HeldPlace place, const std::string& value) {
  std::string result(text);
  result.replace(place.value, place.end - place.value, value);
  const auto key = text.find_first_not_of(" \t", place.hash + 1);
  result.erase(place.hash, key - place.hash);
  return result;
}

/// Where a new line for a key belongs: behind the last of the keys before it in the table that the section has, else at
/// the section's begin.
std::size_t place_for(const Parameter& parameter, std::string_view text, Lines lines,
                      const std::vector<TomlEntry>& entries) {
  std::size_t place = lines.begin;
  const std::string_view section = section_name_of(parameter.key);
  for (const Parameter& each : parameters()) {
    if (each.key == parameter.key) break;
    if (section_name_of(each.key) != section) continue;
    const TomlEntry* entry = find_entry(entries, each.key);
    if (entry == nullptr || entry->end < lines.begin || entry->end > lines.end) continue;
    place = std::max(place, start_of_next_line(text, entry->end));
  }
  return place;
}

std::string with_new_line(const Parameter& parameter, std::string_view text, const std::string& value,
                          const std::vector<TomlEntry>& entries) {
  const std::string line = fmt::format("{} = {}\n", name_of(parameter.key), value);
  const std::string_view section = section_name_of(parameter.key);
  const auto lines = lines_of_section(text, section);
  std::string result(text);
  if (!result.empty() && result.back() != '\n') result += '\n';
  if (!lines) return fmt::format("{}\n[{}]\n{}", result, section, line);
  if (const auto held = held_place(text, *lines, name_of(parameter.key))) return with_place_taken(text, *held, value);
  const std::size_t place = std::min(place_for(parameter, result, *lines, entries), result.size());
  return result.insert(place, line);
}

}  // namespace

std::string typed_text(const TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return typed_item(*whole);
  if (const auto* number = std::get_if<double>(&value)) return typed_item(*number);
  if (const auto* other = std::get_if<TomlOther>(&value)) return other->type;
  std::string text;
  if (const auto* items = std::get_if<std::vector<TomlItem>>(&value)) {
    for (const TomlItem& item : *items) text += (text.empty() ? "" : ", ") + typed_item(item);
  }
  return text;
}

std::string typed_text(const Parameter& parameter, const Value& value) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    std::string text;
    for (const double number : *numbers) {
      text += (text.empty() ? "" : ", ") + base::format_quantity(number, parameter.dimension);
    }
    return text;
  }
  if (std::holds_alternative<std::monostate>(value)) return parameter.need == Need::automatic ? "auto" : "";
  if (const auto* number = std::get_if<double>(&value)) return base::format_quantity(*number, parameter.dimension);
  if (const auto* whole = std::get_if<int>(&value)) return fmt::format("{}", *whole);
  return std::get<std::string>(value);
}

std::string toml_of_typed(const Parameter& parameter, std::string_view typed) {
  typed = trimmed(typed);
  const bool is_pure = parameter.dimension == base::Dimension::number;
  switch (kind_of(parameter)) {
    case Kind::list_of_quantities:
      return list_of_typed(parameter, typed);
    case Kind::quantity:
    case Kind::whole_number:
      if (is_pure) {
        if (const auto number = number_in(typed)) return *number;
      }
      break;
    case Kind::text:
    case Kind::choice:
      break;
  }
  return toml_string(typed);
}

std::string with_value(std::string_view text, std::string_view key, std::string_view typed) {
  const Parameter* parameter = find_parameter(key);
  if (parameter == nullptr) throw InputError(fmt::format("there is no parameter {}", base::in_quotes(key)));
  const std::vector<TomlEntry> entries = entries_of(text);
  const TomlEntry* entry = find_entry(entries, key);
  const bool takes_out = trimmed(typed).empty() && parameter->need != Need::required;
  if (takes_out && entry == nullptr) return std::string(text);

  const std::string value = toml_of_typed(*parameter, typed);
  std::string result(text);
  if (takes_out) {
    result = commented_out(text, *entry);
  } else if (entry != nullptr) {
    result.replace(entry->begin, entry->end - entry->begin, value);
  } else {
    result = with_new_line(*parameter, text, value, entries);
  }

  // Inline tables and the like: rather no change than a wrong one.
  const auto refuse = [&] {
    throw InputError(fmt::format("{} is written in a way that only you can change; change it in the text", key));
  };
  try {
    const std::vector<TomlEntry> after = toml_entries(result);
    const TomlEntry* changed = find_entry(after, key);
    if (takes_out != (changed == nullptr)) refuse();
    if (changed != nullptr && result.substr(changed->begin, changed->end - changed->begin) != value) refuse();
    if (after.size() + (takes_out ? 1 : 0) < entries.size()) refuse();
  } catch (const TomlSyntaxError&) {
    refuse();
  }
  return result;
}

}  // namespace knitmech::model
