#include "study/measures.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "model/frame.h"
#include "results/atomic_file.h"
#include "results/constants.h"
#include "results/history_file.h"
#include "results/summary.h"

namespace knitmech::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using model::HistoryRow;

/// Rounding of a strain that was reached exactly [-].
constexpr double kStrainRounding = 1e-9;

/// What is left of a run, or nothing.
struct Leavings {
  Json summary = Json::object();
  std::vector<HistoryRow> history;
};

Leavings leavings_of(const fs::path& folder) {
  Leavings leavings;
  if (!results::is_summary(folder / results::kSummaryFile)) return leavings;
  leavings.summary = Json::parse(results::read_file(folder / results::kSummaryFile));
  leavings.history = results::read_history(folder / "history.csv");
  return leavings;
}

/// The number at "quality/kinetic_ratio"; a truth is 1 or 0.
std::optional<double> number_at(const Json& summary, const std::string& path) {
  const Json value = summary.value(Json::json_pointer("/" + path), Json{});
  if (value.is_boolean()) return value.get<bool>() ? 1.0 : 0.0;
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

/// The first row at a strain or beyond it; end() if the run did not come so far.
auto row_at(const std::vector<HistoryRow>& history, double strain) {
  return std::ranges::find_if(history, [&](const HistoryRow& row) { return row.strain >= strain - kStrainRounding; });
}

std::optional<double> force_at(const std::vector<HistoryRow>& history, double strain) {
  const auto last = row_at(history, strain);
  if (last == history.end()) return std::nullopt;
  double sum = 0;
  int n_rows = 0;
  for (auto row = history.begin(); row <= last; ++row) {
    if (row->strain <= strain - results::kWindow) continue;
    sum += row->force_top;
    ++n_rows;
  }
  return sum / n_rows;
}

std::optional<double> value_at(const std::vector<HistoryRow>& history, double strain, double HistoryRow::*member) {
  const auto row = row_at(history, strain);
  if (row == history.end()) return std::nullopt;
  return (*row).*member;
}

/// Largest extent of the centrelines out of the plane in all stored frames [mm].
std::optional<double> out_of_plane_of(const Json& summary) {
  std::optional<double> largest;
  for (const Json& frame : summary.value("frames", Json::array())) {
    const auto lowest = number_at(frame, "lowest_z_mm"), highest = number_at(frame, "highest_z_mm");
    if (lowest && highest) largest = std::max(largest.value_or(0), *highest - *lowest);
  }
  return largest;
}

/// Share of the contact force in the middle third of the width, in the last stored frame [-].
std::optional<double> middle_share_of(const Json& summary) {
  const Json frames = summary.value("frames", Json::array());
  return frames.empty() ? std::nullopt : number_at(frames.back(), "contact_force_in_middle_third");
}

}  // namespace

std::vector<Measure> measures_of(const fs::path& run_folder, const std::vector<double>& strains) {
  const Leavings leavings = leavings_of(run_folder);
  const Json& summary = leavings.summary;
  const std::vector<HistoryRow>& history = leavings.history;
  std::vector<Measure> measures;
  const auto add = [&](const char* name, const char* path) { measures.push_back({name, number_at(summary, path)}); };
  add("quasi_static", "quality/quasi_static");
  add("strain", "final/strain");
  add("elements", "model/elements");
  add("steps", "solver/steps");
  add("wall_s", "solver/wall_s");
  add("kinetic_ratio", "quality/kinetic_ratio");
  add("energy_balance", "quality/energy_balance");
  add("penetration_ratio", "quality/penetration_ratio");
  add("toe_strain", "quality/toe_strain");
  add("work_mJ", "final/external_work_mJ");
  add("friction_loss_mJ", "final/friction_loss_mJ");
  add("largest_axial_strain", "largest_in_yarns/axial_strain/value");
  measures.push_back({"out_of_plane_mm", out_of_plane_of(summary)});
  measures.push_back({"contact_force_in_middle_third", middle_share_of(summary)});
  for (const double strain : strains) {
    const std::string at = fmt::format("_at_{:.4g}_percent", 100 * strain);
    measures.push_back({"force_N" + at, force_at(history, strain)});
    measures.push_back({"work_mJ" + at, value_at(history, strain, &HistoryRow::external_work)});
    measures.push_back({"width_mm" + at, value_at(history, strain, &HistoryRow::width)});
  }
  return measures;
}

}  // namespace knitmech::study
