#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/quantity.h"
#include "base/text.h"
#include "curves/check_lines.h"
#include "curves/read_lines.h"
#include "yarn/table_text.h"

namespace knitmech::curves {
namespace {

using Cells = std::vector<std::string_view>;

/// Where the columns stand, and the unit that they say.
struct Head {
  char separator = ',';
  std::size_t yarn = 0;
  std::array<std::size_t, 3> places{};  ///< x, y, z
  std::optional<std::size_t> radius;
  std::size_t least_cells = 0;
  std::optional<base::Unit> unit;
};

[[noreturn]] void refuse(std::size_t line, const std::string& complaint) {
  throw InputError(fmt::format("line {}: {}", line + 1, complaint));
}

char separator_of(std::string_view line) {
  for (const char separator : {';', '\t'}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

/// "mm" of "x_mm", "x [mm]" and "x (mm)"; empty of "x".
std::string_view unit_in(std::string_view head, std::string_view name) {
  std::string_view unit = head.substr(name.size());
  constexpr std::string_view kAround = " _[]()";
  const std::size_t begin = std::min(unit.find_first_not_of(kAround), unit.size());
  unit.remove_prefix(begin);
  return unit.substr(0, unit.find_last_not_of(kAround) + 1);
}

/// Whether a head is that of a column: its name, with a unit or without.
bool is_column(std::string_view head, std::string_view name) {
  return head.starts_with(name) &&
         (head.size() == name.size() || std::string_view(" _[(").find(head[name.size()]) != std::string_view::npos);
}

std::optional<std::size_t> find_column(const Cells& cells, std::string_view name) {
  const auto found = std::ranges::find_if(cells, [&](std::string_view head) { return is_column(head, name); });
  if (found == cells.end()) return std::nullopt;
  if (std::find_if(found + 1, cells.end(), [&](std::string_view head) { return is_column(head, name); }) != cells.end())
    refuse(0, fmt::format("two columns are named {}; leave one of them out", name));
  return static_cast<std::size_t>(found - cells.begin());
}

std::size_t column(const Cells& cells, std::string_view name) {
  const auto found = find_column(cells, name);
  if (!found) {
    refuse(0, fmt::format("names no column {}; a table of yarns begins with yarn,x_mm,y_mm,z_mm", name));
  }
  return *found;
}

/// The unit of a column, which must be that of the columns before it.
void take_unit(Head& head, std::string_view cell, std::string_view name, bool is_first) {
  const std::string_view spelling = unit_in(cell, name);
  std::optional<base::Unit> unit;
  if (!spelling.empty()) {
    const auto units = base::units_of(base::Dimension::length);
    const auto known = std::ranges::find(units, spelling, &base::Unit::name);
    if (known == units.end()) {
      refuse(0, fmt::format("column {}: {} is no unit of length; the units are {}", base::in_quotes(cell),
                            base::in_quotes(spelling), base::unit_names(base::Dimension::length)));
    }
    unit = *known;
  }
  const bool is_same = unit.has_value() == head.unit.has_value() && (!unit || unit->name == head.unit->name);
  if (!is_first && !is_same) {
    refuse(0, fmt::format("column {} has another unit than x; give all lengths in one unit", base::in_quotes(cell)));
  }
  head.unit = unit;
}

Head head_of(std::string_view line) {
  Head head;
  head.separator = separator_of(line);
  Cells cells;
  yarn::split_cells(line, head.separator, cells);
  head.yarn = column(cells, "yarn");
  head.places = {column(cells, "x"), column(cells, "y"), column(cells, "z")};
  head.radius = find_column(cells, "radius");
  constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    take_unit(head, cells[head.places.at(i)], kNames.at(i), i == 0);
  }
  if (head.radius) take_unit(head, cells[*head.radius], "radius", false);
  head.least_cells = 1 + std::max({head.yarn, *std::ranges::max_element(head.places), head.radius.value_or(0)});
  return head;
}

/// Reads the lines behind the head.
class Reading {
 public:
  explicit Reading(const Head& head) : head_(head) {}

  void take(std::string_view text, std::size_t line) {
    yarn::split_cells(text, head_.separator, cells_);
    if (cells_.size() < head_.least_cells) {
      refuse(line,
             fmt::format("has {} cells, but the columns of the first line need {}", cells_.size(), head_.least_cells));
    }
    begin_yarn(cells_[head_.yarn], line);
    YarnLine& yarn = yarns_.back();
    const auto value = [&](std::size_t column) { return length(column, line); };
    yarn.points.emplace_back(value(head_.places[0]), value(head_.places[1]), value(head_.places[2]));
    if (head_.radius) yarn.radius = value(*head_.radius);
  }

  [[nodiscard]] std::vector<YarnLine> yarns() && { return std::move(yarns_); }

 private:
  void begin_yarn(std::string_view name, std::size_t line) {
    if (name.empty()) refuse(line, "says no yarn");
    if (!yarns_.empty() && name == name_) return;
    name_ = name;
    if (!names_.insert(name_).second) {
      refuse(line, fmt::format("yarn {} goes on here, but other yarns came between; keep the lines of a yarn together",
                               base::in_quotes(name)));
    }
    yarns_.emplace_back();
  }

  double length(std::size_t column, std::size_t line) {
    try {
      const double value = numbers_.number(cells_[column]);
      return head_.unit ? value * head_.unit->multiply / head_.unit->divide : value;
    } catch (const InputError& error) {
      refuse(line, error.what());
    }
  }

  const Head& head_;
  Cells cells_;
  std::string name_;
  std::set<std::string> names_;
  std::vector<YarnLine> yarns_;
  yarn::NumberReader numbers_;
};

}  // namespace

YarnLines parse_csv(std::string_view bytes) {
  const std::string text = yarn::table_text(bytes);
  const std::vector<std::string_view> lines = yarn::lines_of(text);
  const Head head = head_of(lines.front());
  Reading reading(head);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!yarn::trimmed(lines[i]).empty()) reading.take(lines[i], i);
  }
  YarnLines result{
      .kind = LineKind::through_points, .yarns = std::move(reading).yarns(), .in_millimetres = head.unit.has_value()};
  std::ranges::for_each(result.yarns, close_where_ends_meet);
  check_lines(result);
  return result;
}

}  // namespace knitmech::curves
