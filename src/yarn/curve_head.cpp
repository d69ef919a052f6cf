#include "yarn/curve_head.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/errors.h"
#include "base/text.h"
#include "yarn/table_text.h"

namespace knitmech::yarn {
namespace {

using Cells = std::vector<std::string_view>;

/// A line that may be the one that names the columns.
struct Candidate {
  std::size_t line = 0;
  std::size_t first_row = 0;
  char separator = ';';
  std::size_t n_cells = 0;
  std::vector<Column> columns;
};

[[noreturn]] void refuse(std::size_t line, const std::string& complaint) {
  throw InputError(fmt::format("line {}: {}", line + 1, complaint));
}

bool has_role(const std::vector<Column>& columns, ColumnRole role) {
  return std::ranges::any_of(columns, [role](const Column& each) { return each.role == role; });
}

std::optional<Candidate> columns_in_line(const std::vector<std::string_view>& lines, std::size_t line,
                                         const ColumnChoice& choice) {
  // A line this long names no columns; it is not searched, so that a file of one endless line ends soon.
  constexpr std::size_t kLongestHead = 20000;
  if (lines[line].size() > kLongestHead) return std::nullopt;
  Cells cells;
  for (const char separator : {'\t', ';', ','}) {
    split_cells(lines[line], separator, cells);
    std::vector<Column> columns = columns_named_in(cells, choice);
    if (has_role(columns, ColumnRole::load) && has_role(columns, ColumnRole::extension)) {
      return Candidate{line, line + 1, separator, cells.size(), std::move(columns)};
    }
  }
  return std::nullopt;
}

std::size_t next_line_with_text(const std::vector<std::string_view>& lines, std::size_t line) {
  while (line < lines.size() && trimmed(lines[line]).empty()) ++line;
  return line;
}

/// Takes the units from the line below the names if all columns of load and extension have one there.
void take_units_below(Candidate& candidate, const std::vector<std::string_view>& lines) {
  const std::size_t line = next_line_with_text(lines, candidate.first_row);
  if (line == lines.size()) return;
  Cells cells;
  split_cells(lines[line], candidate.separator, cells);
  std::vector<Column> columns = candidate.columns;
  for (Column& column : columns) {
    if (column.role == ColumnRole::specimen || column.unit_is_chosen) continue;
    const bool there =
        column.index < cells.size() && !cells[column.index].empty() && !looks_like_number(cells[column.index]);
    if (!there) return;
    column.unit_text = cells[column.index];
    column.unit = find_column_unit(column.unit_text, column.role);
  }
  candidate.columns = std::move(columns);
  candidate.first_row = line + 1;
}

bool numbers_follow(const Candidate& candidate, const std::vector<std::string_view>& lines) {
  const std::size_t line = next_line_with_text(lines, candidate.first_row);
  if (line == lines.size()) return false;
  Cells cells;
  split_cells(lines[line], candidate.separator, cells);
  return std::ranges::any_of(candidate.columns, [&](const Column& column) {
    return column.role != ColumnRole::specimen && column.index < cells.size() && looks_like_number(cells[column.index]);
  });
}

[[noreturn]] void refuse_file(const ColumnChoice& choice) {
  std::vector<std::string> chosen;
  for (const std::string& name : {choice.load, choice.extension}) {
    if (!name.empty()) chosen.push_back(base::in_quotes(name));
  }
  if (!chosen.empty()) {
    throw InputError(
        fmt::format("no line names the columns of a curve with {}; write names as they stand in the file, with the "
                    "unit in brackets behind a name whose column has none",
                    fmt::join(chosen, " and ")));
  }
  throw InputError(
      "no line names the columns of a curve; one must name a force or stress and an elongation, displacement or "
      "strain, with their units, such as Force [N];Strain [%]");
}

Candidate find_candidate(const std::vector<std::string_view>& lines, const ColumnChoice& choice) {
  std::optional<std::size_t> without_numbers;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    auto candidate = columns_in_line(lines, line, choice);
    if (!candidate) continue;
    take_units_below(*candidate, lines);
    if (numbers_follow(*candidate, lines)) return std::move(*candidate);
    without_numbers = without_numbers.value_or(line);
  }
  if (without_numbers) refuse(*without_numbers, "names the columns of a curve, but no numbers follow");
  refuse_file(choice);
}

/// What a 1 in a column of this unit is in N or as strain; empty if a fact is missing for it.
std::optional<double> scale_of(const ColumnUnit& unit, const TestFacts& facts) {
  const double internal = unit.unit.multiply / unit.unit.divide;
  switch (unit.quantity) {
    case ColumnQuantity::force:
    case ColumnQuantity::strain:
      return internal;
    case ColumnQuantity::specific_force:
      if (!facts.linear_density) return std::nullopt;
      return internal * *facts.linear_density;
    case ColumnQuantity::stress:
      if (!facts.diameter) return std::nullopt;
      return internal * std::numbers::pi / 4 * *facts.diameter * *facts.diameter;
    case ColumnQuantity::force_per_width:
      if (!facts.width) return std::nullopt;
      return internal * *facts.width;
    case ColumnQuantity::displacement:
      if (!facts.gauge_length) return std::nullopt;
      return internal / *facts.gauge_length;
  }
  return std::nullopt;
}

std::string missing_fact(ColumnQuantity quantity, const TestFacts& facts) {
  const bool of_section = quantity == ColumnQuantity::specific_force || quantity == ColumnQuantity::stress;
  if (of_section && facts.width)
    return "is for yarns; of a fabric give the force, as in N, or that per width, as in N/mm";
  switch (quantity) {
    case ColumnQuantity::specific_force:
      return R"(is a force per linear density; give the yarn's linear density, as in --linear-density "20 tex")";
    case ColumnQuantity::stress:
      return R"(is a stress; give the yarn's diameter, as in --diameter "0.12 mm")";
    case ColumnQuantity::force_per_width:
      return "is a force per width, as only fabrics have it";
    case ColumnQuantity::displacement:
      return R"(is a displacement; give the length between the grips, as in --gauge-length "100 mm")";
    case ColumnQuantity::force:
    case ColumnQuantity::strain:
      break;
  }
  return "has a unit that cannot be converted";
}

[[noreturn]] void refuse_units(std::size_t line, const std::vector<const Column*>& columns, ColumnRole role,
                               const TestFacts& facts) {
  const Column& first = *columns.front();
  const std::string column = fmt::format("the column {}", base::in_quotes(first.head));
  if (first.unit) refuse(line, fmt::format("{} {}", column, missing_fact(first.unit->quantity, facts)));
  const std::string what = first.unit_text.empty() ? "has no unit"
                                                   : fmt::format("has the unit {}, which is not known here",
                                                                 base::in_quotes(first.unit_text));
  refuse(line, fmt::format("{} {}; write one of {} in brackets behind the name, there or with {}", column, what,
                           column_unit_names(role), role == ColumnRole::load ? "--load-column" : "--extension-column"));
}

/// The columns of one role that are used, and what turns their numbers into N or strain.
struct Axis {
  std::vector<const Column*> columns;
  double scale = 0;
  ColumnQuantity quantity = ColumnQuantity::force;
};

Axis choose_axis(const Candidate& candidate, ColumnRole role, const TestFacts& facts) {
  std::vector<const Column*> all;
  for (const Column& column : candidate.columns) {
    if (column.role == role) all.push_back(&column);
  }
  using enum ColumnQuantity;
  for (const ColumnQuantity quantity : {force, specific_force, stress, force_per_width, strain, displacement}) {
    Axis axis;
    std::ranges::copy_if(all, std::back_inserter(axis.columns), [quantity](const Column* column) {
      return column->unit && column->unit->quantity == quantity;
    });
    if (axis.columns.empty()) continue;
    const ColumnUnit& unit = *axis.columns.front()->unit;
    const auto scale = scale_of(unit, facts);
    if (!scale) continue;
    for (const Column* column : axis.columns) {
      if (column->unit->unit.name == unit.unit.name) continue;
      refuse(candidate.line, fmt::format("the columns {} and {} have different units; keep one of them",
                                         base::in_quotes(axis.columns.front()->head), base::in_quotes(column->head)));
    }
    axis.scale = *scale;
    axis.quantity = quantity;
    return axis;
  }
  refuse_units(candidate.line, all, role, facts);
}

}  // namespace

CurveHead find_curve_head(const std::vector<std::string_view>& lines, const TestFacts& facts) {
  const Candidate candidate = find_candidate(lines, facts.columns);
  const Axis load = choose_axis(candidate, ColumnRole::load, facts);
  const Axis extension = choose_axis(candidate, ColumnRole::extension, facts);
  const std::size_t n_pairs = load.columns.size();
  const bool shared = extension.columns.size() == 1;
  if (!shared && extension.columns.size() != n_pairs) {
    refuse(candidate.line,
           fmt::format("there are {} columns of load and {} of extension; there must be as many of one as "
                       "of the other, or one of extension",
                       n_pairs, extension.columns.size()));
  }
  CurveHead head{.separator = candidate.separator,
                 .line = candidate.line,
                 .first_row = candidate.first_row,
                 .n_cells = candidate.n_cells,
                 .pairs = {},
                 .shared_extension = shared && n_pairs > 1,
                 .specimen_column = {},
                 .per_width = load.quantity == ColumnQuantity::force_per_width,
                 .newton_per_load = load.scale,
                 .strain_per_extension = extension.scale};
  for (std::size_t i = 0; i < n_pairs; ++i) {
    head.pairs.push_back({load.columns[i]->index, extension.columns[shared ? 0 : i]->index});
  }
  const auto specimen = std::ranges::find(candidate.columns, ColumnRole::specimen, &Column::role);
  if (n_pairs == 1 && specimen != candidate.columns.end()) head.specimen_column = {specimen->index};
  return head;
}

}  // namespace knitmech::yarn
