#include "app/compare_texts.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/run_texts.h"

namespace knitmech::app {
namespace {

using compare::Comparison;
using compare::DifferenceAt;
using compare::KnotFit;
using Json = nlohmann::ordered_json;

/// The simulated, the measured value, and by how much the first differs from the second.
std::string pair_text(double simulated, double measured, std::string (*text)(double)) {
  const std::string both = fmt::format("{:>13} {:>13}", text(simulated), text(measured));
  return measured > 0 ? fmt::format("{} {:>+10.1f} %", both, 100 * (simulated / measured - 1)) : both;
}

std::string work_text(double work) {
  return fmt::format("{:.3g} uJ/mm^2", 1000 * work);
}

std::string locking_text(const std::optional<double>& strain) {
  return strain ? percent_text(*strain) : "none";
}

std::string range_text(const DifferenceAt& here, int n_specimens) {
  if (n_specimens < 2) return {};
  return fmt::format("   (measured {} to {})", per_width_text(here.lowest), per_width_text(here.highest));
}

std::string warning_text(const ComparedRun& compared) {
  const std::string& status = compared.simulated.status;
  if (status == "completed") return {};
  return fmt::format("Warning: the run is {}, not completed; compared is what it has written.\n", status);
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json fit_json(const KnotFit& fit, double work) {
  return {{"initial_slope_N_per_mm", fit.initial_slope},
          {"locked_slope_N_per_mm", fit.locked_slope},
          {"locking_strain", optional_json(fit.locking_strain)},
          {"fit_rms_N_per_mm", fit.rms},
          {"work_mJ_per_mm2", work}};
}

Json at_json(const Comparison& comparison) {
  Json list = Json::array();
  for (const DifferenceAt& here : comparison.at) {
    list.push_back({{"strain", here.strain},
                    {"simulated_N_per_mm", here.simulated},
                    {"mean_N_per_mm", here.mean},
                    {"lowest_N_per_mm", here.lowest},
                    {"highest_N_per_mm", here.highest},
                    {"difference_N_per_mm", here.difference},
                    {"difference_ratio", optional_json(here.ratio)}});
  }
  return list;
}

Json specimens_json(const ComparedRun& compared) {
  Json list = Json::array();
  for (const yarn::TensileCurve& curve : compared.measured.specimens) {
    list.push_back({{"name", curve.name},
                    {"largest_force_N_per_mm", curve.forces.back() / compared.facts.width},
                    {"strain_of_largest_force", curve.strains.back()}});
  }
  return list;
}

}  // namespace

std::string compare_text(const ComparedRun& compared) {
  const Comparison& result = compared.comparison;
  const int n = result.n_specimens;
  std::string text =
      fmt::format("{} ({}) and {} measured curve{}, from {} to {} strain\n", compared.simulated.title, compared.run, n,
                  n == 1 ? "" : "s", percent_text(result.strains.front()), percent_text(result.strains.back()));
  const auto add = [&](const std::string& name, const std::string& value) {
    text += fmt::format("  {:22}{}\n", name, value);
  };
  add("simulated fabric", fmt::format("{:.4g} mm wide, {:.4g} mm between the grips", compared.simulated.width,
                                      compared.simulated.gauge_length));
  add("specimens", fmt::format("taken as {:.4g} mm wide, {:.4g} mm between the grips", compared.facts.width,
                               compared.facts.gauge_length));
  if (result.offset != 0) add("offset", fmt::format("{} taken from the measured strains", percent_text(result.offset)));
  add("RMS difference",
      fmt::format("{}, {} of the largest measured force", per_width_text(result.rms), percent_text(result.rms_ratio)));
  if (result.share_in_range) {
    add("within the specimens", fmt::format("at {} of the strains", percent_text(*result.share_in_range)));
  }
  text += fmt::format("  {:22}{:>13} {:>13} {:>12}\n", "", "simulated", n == 1 ? "measured" : "mean", "difference");
  for (const DifferenceAt& here : result.at) {
    add(fmt::format("force at {}", percent_text(here.strain)),
        pair_text(here.simulated, here.mean, per_width_text) + range_text(here, n));
  }
  const KnotFit& simulated = result.simulated_fit;
  const KnotFit& measured = result.measured_fit;
  add("initial slope", pair_text(simulated.initial_slope, measured.initial_slope, per_width_text));
  add("slope after locking", pair_text(simulated.locked_slope, measured.locked_slope, per_width_text));
  add("locking strain",
      fmt::format("{:>13} {:>13}", locking_text(simulated.locking_strain), locking_text(measured.locking_strain)));
  add("work", pair_text(result.simulated_work, result.measured_work, work_text));
  return text + warning_text(compared);
}

std::string compare_json(const ComparedRun& compared, const std::filesystem::path& folder) {
  const Comparison& result = compared.comparison;
  const Json document{{"run", compared.run},
                      {"title", compared.simulated.title},
                      {"status", compared.simulated.status},
                      {"fabric_width_mm", compared.simulated.width},
                      {"specimen_width_mm", compared.facts.width},
                      {"specimen_gauge_length_mm", compared.facts.gauge_length},
                      {"specimens", specimens_json(compared)},
                      {"from_strain", result.strains.front()},
                      {"to_strain", result.strains.back()},
                      {"offset", result.offset},
                      {"rms_N_per_mm", result.rms},
                      {"rms_ratio", result.rms_ratio},
                      {"largest_measured_N_per_mm", result.largest_force},
                      {"share_in_range", optional_json(result.share_in_range)},
                      {"simulated", fit_json(result.simulated_fit, result.simulated_work)},
                      {"measured", fit_json(result.measured_fit, result.measured_work)},
                      {"at", at_json(result)},
                      {"folder", folder.string()}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace knitmech::app
