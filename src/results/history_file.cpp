#include "results/history_file.h"

#include <fmt/format.h>

#include <string_view>

#include "base/errors.h"
#include "results/atomic_file.h"
#include "results/csv_text.h"

namespace knitmech::results {
namespace {

using model::HistoryRow;

HistoryRow parse_row(std::string_view line, const std::vector<std::string_view>& columns, const CsvPlace& place) {
  const std::vector<std::string_view> cells = csv_cells(line);
  if (cells.size() != columns.size()) {
    throw InputError(fmt::format("{}, line {}: expected {} numbers separated by commas, found {}.", place.path.string(),
                                 place.line, columns.size(), cells.size()));
  }
  HistoryRow row;
  std::size_t at = 0;
  for (double* member : {&row.time, &row.displacement, &row.strain, &row.force_top, &row.force_bottom,
                         &row.external_work, &row.internal_energy, &row.stretch_energy, &row.kinetic_energy,
                         &row.contact_energy, &row.friction_loss, &row.damping_loss, &row.break_loss, &row.width}) {
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

}  // namespace

std::array<double, kHistoryColumns> history_values(const HistoryRow& row) {
  return {row.time,
          row.displacement,
          row.strain,
          row.force_top,
          row.force_bottom,
          row.external_work,
          row.internal_energy,
          row.stretch_energy,
          row.kinetic_energy,
          row.contact_energy,
          row.friction_loss,
          row.damping_loss,
          row.break_loss,
          row.width,
          static_cast<double>(row.contacts),
          row.normal_force,
          row.largest_elastic_slip,
          row.largest_penetration,
          row.step};
}

std::string history_line(const HistoryRow& row) {
  return fmt::format("{}\n", fmt::join(history_values(row), ","));
}

std::vector<HistoryRow> read_history(const std::filesystem::path& path) {
  const std::string content = read_file(path);
  const std::vector<std::string_view> lines = csv_lines(content);
  if (lines.empty() || lines.front() != kHistoryHeader) {
    throw InputError(
        fmt::format("{}, line 1: expected the header of a KnitMech history, \"{}\".", path.string(), kHistoryHeader));
  }
  const std::vector<std::string_view> columns = csv_cells(kHistoryHeader);
  std::vector<HistoryRow> rows;
  rows.reserve(lines.size() - 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    rows.push_back(parse_row(lines[i], columns, CsvPlace{path, static_cast<int>(i) + 1}));
  }
  return rows;
}

}  // namespace knitmech::results
