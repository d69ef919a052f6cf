#include "results/curve_stages.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "base/line_slope.h"
#include "results/constants.h"
#include "results/curve_measures.h"

namespace knitmech::results {
namespace {

using model::HistoryRow;
using Rows = std::span<const HistoryRow>;

Rows up_to_break(const std::vector<HistoryRow>& history) {
  const auto broken = std::ranges::find_if(history, [](const HistoryRow& row) { return row.break_loss > 0; });
  return Rows{history}.first(static_cast<std::size_t>(broken - history.begin()));
}

/// Strain at which a quantity that is a before and b after two rows is zero.
double strain_of_zero(double strain_a, double a, double strain_b, double b) {
  return strain_a + (strain_b - strain_a) * a / (a - b);
}

/// Where the strain energy first reaches a value; empty if it never does.
std::optional<double> strain_of_energy(Rows rows, double energy) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!(rows[i].internal_energy >= energy)) continue;
    return strain_of_zero(rows[i - 1].strain, rows[i - 1].internal_energy - energy, rows[i].strain,
                          rows[i].internal_energy - energy);
  }
  return std::nullopt;
}

/// Growth of the energies over a window of strain that ends with a row.
struct Growth {
  double strain = 0;   ///< the middle of the window
  double stretch = 0;  ///< [mJ]
  double rest = 0;     ///< [mJ], of bending, twist and folds

  [[nodiscard]] double lead() const { return stretch - rest; }
};

/// One for each row that has a window before it in which the strain is at least `from`.
std::vector<Growth> growths(Rows rows, double from) {
  std::vector<Growth> list;
  std::size_t begin = 0;
  for (std::size_t end = 1; end < rows.size(); ++end) {
    const double start = rows[end].strain - kWindow;
    while (begin + 1 < end && rows[begin + 1].strain <= start) ++begin;
    if (rows[begin].strain > start || rows[begin].strain < from) continue;
    const HistoryRow& a = rows[begin];
    const HistoryRow& b = rows[end];
    const double stretch = b.stretch_energy - a.stretch_energy;
    list.push_back({0.5 * (a.strain + b.strain), stretch, b.internal_energy - a.internal_energy - stretch});
  }
  return list;
}

/// The strain from which on stretch leads, the end of the toe if it always does; empty if it does not at the end, or
/// not for long enough.
std::optional<double> begin_of_stretching(const std::vector<Growth>& list, double toe_end, double end_of_curve) {
  std::size_t first = list.size();
  while (first > 0 && list[first - 1].lead() > 0) --first;
  if (first == list.size()) return std::nullopt;
  const double begin = first == 0 ? toe_end
                                  : strain_of_zero(list[first - 1].strain, list[first - 1].lead(), list[first].strain,
                                                   list[first].lead());
  return begin + kWindow <= end_of_curve ? std::optional(begin) : std::nullopt;
}

CurveStage stage(const char* name, double from, double to, Rows rows, double start_width) {
  CurveStage result{.name = name, .from = from, .to = to, .slope = {}, .slope_per_width = {}};
  std::vector<double> strains;
  std::vector<double> forces;
  for (const HistoryRow& row : rows) {
    if (row.strain < from || row.strain > to) continue;
    strains.push_back(row.strain);
    forces.push_back(curve_force(row));
  }
  result.slope = base::line_slope(strains, forces);
  if (result.slope) result.slope_per_width = *result.slope / start_width;
  return result;
}

}  // namespace

CurveStages curve_stages(const std::vector<HistoryRow>& history, double bending_measure) {
  CurveStages result;
  const Rows rows = up_to_break(history);
  if (rows.empty()) return result;
  const double end = rows.back().strain;
  const auto add = [&](const char* name, double from, double to) {
    if (from < to) result.stages.push_back(stage(name, from, to, rows, rows.front().width));
  };
  const auto toe_end = strain_of_energy(rows, kToeEnergy * bending_measure);
  add("toe", rows.front().strain, toe_end.value_or(end));
  result.bending_strain = toe_end;
  if (!toe_end) return result;

  const std::vector<Growth> list = growths(rows, *toe_end);
  result.stretch_strain = begin_of_stretching(list, *toe_end, end);
  if (!list.empty() && list.back().stretch + list.back().rest > 0) {
    result.stretch_share = list.back().stretch / (list.back().stretch + list.back().rest);
  }
  add("bending", *toe_end, result.stretch_strain.value_or(end));
  if (result.stretch_strain) add("stretching", *result.stretch_strain, end);
  return result;
}

}  // namespace knitmech::results
