#include "exchange/abaqus_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>

#include "base/errors.h"
#include "base/text.h"
#include "exchange/constants.h"

namespace knitmech::exchange {

namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(kBlanks) - first + 1));
}

std::string in_capitals(std::string text) {
  for (char& letter : text) {
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  }
  return text;
}

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char letter) { return letter == ' ' || letter == '\t'; });
  return text;
}

std::vector<std::string> cut_at_commas(std::string_view text) {
  std::vector<std::string> parts;
  while (true) {
    const auto comma = text.find(',');
    parts.push_back(trimmed(text.substr(0, comma)));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

std::string label(const std::string& text) {
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') return text.substr(1, text.size() - 2);
  return in_capitals(text);
}

void add_options(KeywordBlock& block, const std::vector<std::string>& parts, std::size_t first) {
  for (std::size_t i = first; i < parts.size(); ++i) {
    if (parts[i].empty()) continue;
    const auto equals = parts[i].find('=');
    const std::string name = without_blanks(in_capitals(parts[i].substr(0, equals)));
    block.options[name] = equals == std::string::npos ? "" : label(trimmed(parts[i].substr(equals + 1)));
  }
}

KeywordBlock begin_block(const std::string& text, int line, const std::string& source) {
  const std::vector<std::string> parts = cut_at_commas(text);
  KeywordBlock block;
  block.as_written = parts.front();
  block.keyword = without_blanks(in_capitals(parts.front().substr(1)));
  block.line = line;
  if (block.keyword.empty()) fail_at(source, line, "a keyword is missing after the *; expected for example *NODE");
  add_options(block, parts, 1);
  return block;
}

void add_data_line(KeywordBlock& block, const std::string& text, int line) {
  DataLine data{line, cut_at_commas(text)};
  for (std::string& entry : data.entries) entry = label(entry);
  block.data.push_back(std::move(data));
  block.text.push_back(text);
}

}  // namespace

bool DataLine::is_blank() const {
  return entries.size() == 1 && entries.front().empty();
}

std::string DataLine::entry(std::size_t i) const {
  return i < entries.size() ? entries[i] : "";
}

bool KeywordBlock::has(std::string_view option) const {
  return options.contains(std::string(option));
}

std::string KeywordBlock::option(std::string_view name, std::string_view fallback) const {
  const auto found = options.find(std::string(name));
  return found == options.end() ? std::string(fallback) : found->second;
}

std::vector<KeywordBlock> read_keyword_blocks(std::istream& in, const std::string& source) {
  std::vector<KeywordBlock> blocks;
  std::string text;
  bool keyword_goes_on = false;
  for (int line = 1; std::getline(in, text); ++line) {
    text = trimmed(text);
    if (text.size() > kAbaqusLineWidth) {
      fail_at(source, line, fmt::format("{} characters; at most {} are allowed", text.size(), kAbaqusLineWidth));
    }
    if (text.starts_with("**")) continue;
    if (keyword_goes_on) {
      add_options(blocks.back(), cut_at_commas(text), 0);
      keyword_goes_on = text.ends_with(',');
    } else if (text.starts_with('*')) {
      blocks.push_back(begin_block(text, line, source));
      keyword_goes_on = text.ends_with(',');
    } else if (!blocks.empty()) {
      add_data_line(blocks.back(), text, line);
    } else if (!text.empty()) {
      fail_at(source, line,
              fmt::format("{} before the first keyword; expected a line such as *HEADING", base::in_quotes(text)));
    }
  }
  if (blocks.empty()) throw InputError(fmt::format("{}: no keyword in it; expected an Abaqus input file", source));
  return blocks;
}

void fail_at(const std::string& source, int line, const std::string& message) {
  throw InputError(fmt::format("{}, line {}: {}", source, line, message));
}

double real_number(const std::string& source, int line, const std::string& entry) {
  if (entry.empty()) return 0;
  if (entry.size() > kAbaqusNumberWidth) {
    fail_at(source, line,
            fmt::format("the number {} has more than {} characters", base::in_quotes(entry), kAbaqusNumberWidth));
  }
  std::string text = entry.front() == '+' ? entry.substr(1) : entry;
  std::replace(text.begin(), text.end(), 'D', 'E');
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    fail_at(source, line, fmt::format("{} is not a number", base::in_quotes(entry)));
  }
  return value;
}

int integer(const std::string& source, int line, const std::string& entry) {
  int value = 0;
  const auto [end, error] = std::from_chars(entry.data(), entry.data() + entry.size(), value);
  if (error != std::errc() || end != entry.data() + entry.size()) {
    fail_at(source, line, fmt::format("{} is not a whole number", base::in_quotes(entry)));
  }
  return value;
}

bool looks_like_number(const std::string& entry) {
  return !entry.empty() &&
         (entry.front() == '-' || entry.front() == '+' || (entry.front() >= '0' && entry.front() <= '9'));
}

}  // namespace knitmech::exchange
