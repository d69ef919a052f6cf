#include "yarn/tensile_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>

#include "base/errors.h"
#include "base/text.h"
#include "yarn/curve_head.h"
#include "yarn/table_text.h"

namespace knitmech::yarn {
namespace {

/// The curves of one file while its rows are read.
class CurveRows {
 public:
  explicit CurveRows(const CurveHead& head)
      : head_(head), curves_(head.specimen_column.empty() ? head.pairs.size() : 0) {
    for (std::size_t i = 0; i < curves_.size(); ++i) curves_[i].name = std::to_string(i + 1);
  }

  void add(const std::vector<std::string_view>& cells) {
    check_number_of_cells(cells);
    for (std::size_t i = 0; i < head_.pairs.size(); ++i) {
      const std::string_view load = cell(cells, head_.pairs[i].load);
      const std::string_view extension = cell(cells, head_.pairs[i].extension);
      if (load.empty() && (extension.empty() || head_.shared_extension)) continue;
      if (load.empty() || extension.empty()) {
        throw InputError(fmt::format("there is a number for the {}, but none for the {}",
                                     load.empty() ? "extension" : "load", load.empty() ? "load" : "extension"));
      }
      TensileCurve& curve =
          head_.specimen_column.empty() ? curves_[i] : curve_of(cell(cells, head_.specimen_column[0]));
      curve.strains.push_back(finite(numbers_.number(extension) * head_.strain_per_extension));
      curve.forces.push_back(finite(numbers_.number(load) * head_.newton_per_load));
    }
  }

  [[nodiscard]] std::vector<TensileCurve> take() { return std::move(curves_); }

 private:
  static std::string_view cell(const std::vector<std::string_view>& cells, std::size_t index) {
    return index < cells.size() ? cells[index] : std::string_view();
  }

  static double finite(double value) {
    if (!std::isfinite(value)) throw InputError("a number is too large");
    return value;
  }

  /// Cells beyond the named columns are how a decimal comma in a file separated by commas shows.
  void check_number_of_cells(const std::vector<std::string_view>& cells) const {
    for (std::size_t i = head_.n_cells; i < cells.size(); ++i) {
      if (cells[i].empty()) continue;
      throw InputError(
          fmt::format("has {} cells, but line {} names {} columns; a decimal comma must not also separate the columns",
                      i + 1, head_.line + 1, head_.n_cells));
    }
  }

  TensileCurve& curve_of(std::string_view specimen) {
    if (specimen.empty()) {
      if (curves_.empty()) throw InputError("the cell of the specimen is empty");
      return curves_[last_specimen_];
    }
    const auto [found, is_new] = specimens_.try_emplace(std::string(specimen), curves_.size());
    if (is_new) curves_.push_back({.name = std::string(specimen), .strains = {}, .forces = {}});
    last_specimen_ = found->second;
    return curves_[last_specimen_];
  }

  const CurveHead& head_;
  NumberReader numbers_;
  std::vector<TensileCurve> curves_;
  std::unordered_map<std::string, std::size_t> specimens_;  ///< index of the curve by the name of its specimen
  std::size_t last_specimen_ = 0;
};

std::vector<TensileCurve> read_rows(const std::vector<std::string_view>& lines, const CurveHead& head) {
  CurveRows rows(head);
  std::vector<std::string_view> cells;
  for (std::size_t line = head.first_row; line < lines.size(); ++line) {
    if (trimmed(lines[line]).empty()) continue;
    split_cells(lines[line], head.separator, cells);
    try {
      rows.add(cells);
    } catch (const InputError& error) {
      throw InputError(fmt::format("line {}: {}", line + 1, error.what()));
    }
  }
  return rows.take();
}

std::vector<TensileCurve> curves_in(std::string_view bytes, const std::string& file, const TestFacts& facts) {
  const std::string text = table_text(bytes);
  const std::vector<std::string_view> lines = lines_of(text);
  const CurveHead head = find_curve_head(lines, facts);
  std::vector<TensileCurve> curves = read_rows(lines, head);
  for (TensileCurve& curve : curves) {
    if (curve.strains.size() < 2) {
      throw InputError(fmt::format("specimen {} has {} points, but a curve needs at least 2",
                                   base::in_quotes(curve.name), curve.strains.size()));
    }
    curve.specimen = curve.name;
    curve.per_width = head.per_width;
    curve.name = curves.size() == 1 ? file : fmt::format("{}, specimen {}", file, curve.name);
  }
  return curves;
}

void check_facts(const TestFacts& facts) {
  const auto check = [](const char* name, const std::optional<double>& value) {
    if (value && !(*value > 0 && std::isfinite(*value))) {
      throw InputError(fmt::format("the {} must be more than 0.", name));
    }
  };
  check("diameter", facts.diameter);
  check("linear density", facts.linear_density);
  check("gauge length", facts.gauge_length);
  check("width", facts.width);
}

}  // namespace

std::vector<TensileCurve> read_tensile_curves(std::string_view bytes, const std::string& file, const TestFacts& facts) {
  check_facts(facts);
  try {
    return curves_in(bytes, file, facts);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace knitmech::yarn
