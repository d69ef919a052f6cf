#include "results/history_file.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <string_view>

#include "base/errors.h"
#include "results/atomic_file.h"

namespace knitmech::results {
namespace {

using model::HistoryRow;

/// Where the reader is, for its messages.
struct Place {
  const std::filesystem::path& path;
  int line = 0;
};

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

template <typename Number>
Number parse_number(std::string_view text, std::string_view column, const Place& place) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) {
    throw InputError(fmt::format("{}, line {}, column {}: expected a number, found \"{}\".", place.path.string(),
                                 place.line, column, text));
  }
  return value;
}

HistoryRow parse_row(std::string_view line, const std::vector<std::string_view>& columns, const Place& place) {
  const std::vector<std::string_view> cells = split(line, ',');
  if (cells.size() != columns.size()) {
    throw InputError(fmt::format("{}, line {}: expected {} numbers separated by commas, found {}.", place.path.string(),
                                 place.line, columns.size(), cells.size()));
  }
  HistoryRow row;
  std::size_t at = 0;
  for (double* member : {&row.time, &row.displacement, &row.strain, &row.force_top, &row.force_bottom,
                         &row.external_work, &row.internal_energy, &row.kinetic_energy, &row.contact_energy,
                         &row.friction_loss, &row.damping_loss, &row.break_loss, &row.width}) {
    *member = parse_number<double>(cells[at], columns[at], place);
    ++at;
  }
  row.contacts = parse_number<int>(cells[at], columns[at], place);
  ++at;
  for (double* member : {&row.normal_force, &row.largest_elastic_slip, &row.largest_penetration, &row.step}) {
    *member = parse_number<double>(cells[at], columns[at], place);
    ++at;
  }
  return row;
}

void remove_carriage_return(std::string_view& line) {
  if (!line.empty() && line.back() == '\r') {
    line.remove_suffix(1);
  }
}

}  // namespace

std::string history_line(const HistoryRow& row) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", row.time, row.displacement, row.strain,
                     row.force_top, row.force_bottom, row.external_work, row.internal_energy, row.kinetic_energy,
                     row.contact_energy, row.friction_loss, row.damping_loss, row.break_loss, row.width, row.contacts,
                     row.normal_force, row.largest_elastic_slip, row.largest_penetration, row.step);
}

std::vector<HistoryRow> read_history(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  std::vector<std::string_view> lines = split(content, '\n');
  for (std::string_view& line : lines) {
    remove_carriage_return(line);
  }
  while (!lines.empty() && lines.back().empty()) {
    lines.pop_back();
  }
  if (lines.empty() || lines.front() != kHistoryHeader) {
    throw InputError(
        fmt::format("{}, line 1: expected the header of a KnitMech history, \"{}\".", path.string(), kHistoryHeader));
  }
  const std::vector<std::string_view> columns = split(kHistoryHeader, ',');
  std::vector<HistoryRow> rows;
  rows.reserve(lines.size() - 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    rows.push_back(parse_row(lines[i], columns, Place{path, static_cast<int>(i) + 1}));
  }
  return rows;
}

}  // namespace knitmech::results
