#include "results/csv_text.h"

#include <fmt/core.h>

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::results {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::vector<std::string_view> csv_lines(std::string_view content) {
  std::vector<std::string_view> lines = split(content, '\n');
  for (std::string_view& line : lines) {
    if (line.ends_with('\r')) line.remove_suffix(1);
  }
  while (!lines.empty() && lines.back().empty()) {
    lines.pop_back();
  }
  return lines;
}

std::vector<std::string_view> csv_cells(std::string_view line) {
  return split(line, ',');
}

void throw_wrong_cell(std::string_view cell, std::string_view column, const CsvPlace& place,
                      std::string_view expected) {
  throw InputError(fmt::format("{}, line {}, column {}: expected {}, found {}.", place.path.string(), place.line,
                               column, expected, base::in_quotes(cell)));
}

}  // namespace knitmech::results
