#include "yarn/table_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::yarn {
namespace {

constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";
constexpr std::string_view kUtf16LittleMark = "\xff\xfe";
constexpr std::string_view kUtf16BigMark = "\xfe\xff";
constexpr std::string_view kNoBreakSpace = "\xc2\xa0";

unsigned char code_of(char letter) {
  return static_cast<unsigned char>(letter);
}

/// Length of the UTF-8 letter that begins with this byte; 0 if none does.
std::size_t length_of_letter(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  if (first >= 0xf0 && first < 0xf5) return 4;
  return 0;
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_letter(code_of(text[i]));
    if (length == 0 || i + length > text.size()) return false;
    for (std::size_t j = 1; j < length; ++j) {
      if ((code_of(text[i + j]) & 0xc0) != 0x80) return false;
    }
    i += length;
  }
  return true;
}

std::string from_latin_1(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char byte : bytes) {
    if (code_of(byte) < 0x80) {
      text += byte;
    } else {
      text += static_cast<char>(0xc0 | (code_of(byte) >> 6));
      text += static_cast<char>(0x80 | (code_of(byte) & 0x3f));
    }
  }
  return text;
}

/// Where the cell that begins here ends: at the next separator that is not between double quotes.
std::size_t end_of_cell(std::string_view line, std::size_t begin, char separator) {
  const std::size_t first = line.find_first_not_of(' ', begin);
  std::size_t from = begin;
  if (first != std::string_view::npos && line[first] == '"') {
    const std::size_t closing = line.find('"', first + 1);
    if (closing != std::string_view::npos) from = closing;
  }
  return std::min(line.find(separator, from), line.size());
}

std::string_view unquoted(std::string_view cell) {
  const bool quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

}  // namespace

std::string table_text(std::string_view bytes) {
  if (bytes.starts_with(kUtf16LittleMark) || bytes.starts_with(kUtf16BigMark)) {
    throw InputError("is UTF-16 text; save it as UTF-8");
  }
  if (bytes.find('\0') != std::string_view::npos) {
    throw InputError("is not a text file; export the curve as text with separators (CSV)");
  }
  if (bytes.starts_with(kUtf8Mark)) bytes.remove_prefix(kUtf8Mark.size());
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) throw InputError("is empty");
  return is_utf8(bytes) ? std::string(bytes) : from_latin_1(bytes);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    lines.push_back(text.substr(0, end));
    const bool two = text.substr(end).starts_with("\r\n");
    text.remove_prefix(std::min(end + (two ? 2 : 1), text.size()));
  }
  return lines;
}

void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  for (std::size_t begin = 0;;) {
    const std::size_t end = end_of_cell(line, begin, separator);
    cells.push_back(unquoted(trimmed(line.substr(begin, end - begin))));
    if (end == line.size()) return;
    begin = end + 1;
  }
}

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char letter) { return letter == ' ' || letter == '\t'; };
  for (;;) {
    if (!text.empty() && is_blank(text.front())) {
      text.remove_prefix(1);
    } else if (text.starts_with(kNoBreakSpace)) {
      text.remove_prefix(kNoBreakSpace.size());
    } else if (!text.empty() && is_blank(text.back())) {
      text.remove_suffix(1);
    } else if (text.ends_with(kNoBreakSpace)) {
      text.remove_suffix(kNoBreakSpace.size());
    } else {
      return text;
    }
  }
}

double NumberReader::number(std::string_view cell) {
  const auto refuse = [cell](std::string_view complaint) {
    throw InputError(fmt::format("{} {}", base::in_quotes(cell), complaint));
  };
  constexpr std::string_view kNoNumber = "is no number, where one such as 12.5 or 12,5 is due";
  constexpr std::size_t kLongest = 64;
  if (cell.size() > kLongest) refuse(kNoNumber);
  std::string text(cell);
  const std::size_t mark = text.find_first_of(".,");
  if (mark != std::string::npos) {
    if (text.find_first_of(".,", mark + 1) != std::string::npos) {
      refuse("is no number; write numbers with one decimal mark and without thousands separators");
    }
    if (decimal_mark_.value_or(text[mark]) != text[mark]) {
      refuse(fmt::format("has a decimal {}, but numbers before it have a decimal {}; use one of them throughout",
                         text[mark] == ',' ? "comma" : "point", text[mark] == ',' ? "point" : "comma"));
    }
  }
  std::string usual = text;
  if (mark != std::string::npos) usual[mark] = '.';
  const bool plus = usual.starts_with('+') && !usual.starts_with("+-");
  const char* const begin = usual.data() + (plus ? 1 : 0);
  const char* const end = usual.data() + usual.size();
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range) refuse("is too large or too small a number");
  if (error != std::errc{} || stop != end) refuse(kNoNumber);
  if (!std::isfinite(value)) refuse("is no finite number; leave such rows out");
  if (mark != std::string::npos) decimal_mark_ = text[mark];
  return value;
}

bool looks_like_number(std::string_view cell) {
  const std::size_t first = cell.find_first_not_of("+-.,");
  return first != std::string_view::npos && cell[first] >= '0' && cell[first] <= '9';
}

}  // namespace knitmech::yarn
