#include "compare/simulated_curve.h"

#include <fmt/format.h>

#include <system_error>

#include "base/errors.h"
#include "base/text.h"
#include "results/curve_measures.h"
#include "results/history_file.h"
#include "results/summary.h"

namespace knitmech::compare {

namespace fs = std::filesystem;

void set_curve(SimulatedCurve& curve, const std::vector<model::HistoryRow>& history) {
  curve.strains.clear();
  curve.forces.clear();
  if (!history.empty()) curve.width = history.front().width;
  for (const model::HistoryRow& row : history) {
    if (row.break_loss > 0) break;
    if (!curve.strains.empty() && row.strain <= curve.strains.back()) continue;
    curve.strains.push_back(row.strain);
    curve.forces.push_back(results::curve_force(row));
  }
}

SimulatedCurve read_simulated_curve(const fs::path& run) {
  std::error_code ignored;
  if (!fs::exists(run, ignored)) {
    throw FileError(fmt::format("cannot read {}: there is no such folder", base::in_quotes(run.string())));
  }
  const fs::path summary = run / results::kSummaryFile;
  if (!results::is_summary(summary)) {
    throw InputError(fmt::format("{} is no folder of a KnitMech run; give one that `knitmech run` has left",
                                 base::in_quotes(run.string())));
  }
  const results::SummaryFacts facts = results::facts_in_summary(summary);
  SimulatedCurve curve{
      .title = facts.title, .status = facts.status, .gauge_length = facts.gauge_length, .strains = {}, .forces = {}};
  const fs::path history = run / results::kHistoryFile;
  set_curve(curve, results::read_history(history));
  if (curve.strains.size() < 2) {
    throw InputError(fmt::format("{}: has {} rows, but a curve needs at least 2; let the run go on further",
                                 history.string(), curve.strains.size()));
  }
  return curve;
}

}  // namespace knitmech::compare
