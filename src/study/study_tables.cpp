#include "study/study_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/number_text.h"
#include "base/text.h"
#include "report/page.h"
#include "results/frame_measures.h"
#include "results/read_frame.h"

namespace knitmech::study {
namespace {

constexpr int kDigits = 5;

std::string number_text(const std::optional<double>& value) {
  constexpr double kLongNumber = 1e4;
  if (!value) return {};
  const bool is_long_count = std::abs(*value) >= kLongNumber && *value == std::round(*value);
  return is_long_count ? fmt::format("{:.0f}", *value) : fmt::format("{:.4g}", *value);
}

/// What stands above a column of the values of a variation.
std::string head_of(const Variation& variation) {
  return fmt::format("<code>{}</code>", base::in_markup(model::name_of(variation.parameter->key)));
}

/// A row of a table that begins with the values of a variant.
std::vector<std::string> row_of(const Study& study, const VariantState& state) {
  std::vector<std::string> row = {base::in_markup(state.variant.name)};
  for (std::size_t i = 0; i < study.variations.size(); ++i) {
    row.push_back(base::in_markup(value_text(*study.variations[i].parameter, state.variant.values[i], kDigits)));
  }
  return row;
}

std::vector<std::string> head_row(const Study& study) {
  std::vector<std::string> row = {"run"};
  for (const Variation& variation : study.variations) row.push_back(head_of(variation));
  return row;
}

std::string standing_cell(const VariantState& state) {
  if (!is_completed(state)) {
    return fmt::format("<span class=\"bad\">{}</span> {}", name_of(state.standing), base::in_markup(state.reason));
  }
  return measure(state, "quasi_static") == 1.0 ? "<span class=\"good\">quasi-static</span>"
                                               : "<span class=\"bad\">not quasi-static</span>";
}

/// The variant that the others are compared with: the finest mesh, or else the first that is completed.
const VariantState* reference_of(const Study& study, const std::vector<VariantState>& states) {
  const bool is_mesh_study =
      study.variations.size() == 1 && study.variations.front().parameter->key == "fabric.elements_per_erc";
  const VariantState* reference = nullptr;
  for (const VariantState& state : states) {
    if (!is_completed(state)) continue;
    const bool is_finer =
        reference != nullptr && is_mesh_study &&
        std::get<int>(state.variant.values.front()) > std::get<int>(reference->variant.values.front());
    if (reference == nullptr || is_finer) reference = &state;
  }
  return reference;
}

/// A measure of each run at each strain, and how far it is from that of the reference.
std::string table_at_strains(const Study& study, const std::vector<VariantState>& states, const char* name,
                             const VariantState& reference) {
  std::vector<std::vector<std::string>> rows = {head_row(study)};
  for (const double strain : study.strains) {
    rows.front().push_back("at " + base::percent_text(strain));
    rows.front().emplace_back("");
  }
  for (const VariantState& state : states) {
    if (!is_completed(state)) continue;
    std::vector<std::string> row = row_of(study, state);
    for (const double strain : study.strains) {
      const auto value = measure(state, at(name, strain)), other = measure(reference, at(name, strain));
      row.push_back(number_text(value));
      const bool has_difference = value && other && *other != 0 && &state != &reference;
      row.push_back(has_difference ? fmt::format("{:+.1f} %", 100 * (*value / *other - 1)) : "");
    }
    rows.push_back(std::move(row));
  }
  return report::table(rows);
}

std::vector<std::string> comparison_row(std::vector<std::string> row, const compare::Comparison& comparison) {
  const compare::KnotFit& simulated = comparison.simulated_fit;
  const compare::KnotFit& measured = comparison.measured_fit;
  row.push_back(number_text(comparison.rms));
  row.push_back(base::percent_text(comparison.rms_ratio));
  row.push_back(comparison.share_in_range ? base::percent_text(*comparison.share_in_range) : "");
  row.push_back(base::percent_text(comparison.offset));
  for (const compare::KnotFit* fit : {&simulated, &measured}) row.push_back(number_text(fit->initial_slope));
  for (const compare::KnotFit* fit : {&simulated, &measured})
    row.push_back(fit->locking_strain ? base::percent_text(*fit->locking_strain) : "");
  for (const compare::KnotFit* fit : {&simulated, &measured}) row.push_back(number_text(fit->locked_slope));
  row.push_back(number_text(comparison.simulated_work / comparison.measured_work));
  return row;
}

}  // namespace

std::string title_of(const Study& study, const Variant& variant) {
  std::string title;
  for (std::size_t i = 0; i < study.variations.size(); ++i) {
    const model::Parameter& parameter = *study.variations[i].parameter;
    title += fmt::format("{}{} = {}", i == 0 ? "" : ", ", model::name_of(parameter.key),
                         value_text(parameter, variant.values[i], kDigits));
  }
  return title.empty() ? "base" : title;
}

std::optional<double> measure(const VariantState& state, const std::string& name) {
  const auto found = std::ranges::find(state.measures, name, &Measure::name);
  return found == state.measures.end() ? std::nullopt : found->value;
}

std::string at(const char* name, double strain) {
  return fmt::format("{}_at_{:.4g}_percent", name, 100 * strain);
}

std::string table_of_runs(const Study& study, const std::vector<VariantState>& states) {
  std::vector<std::vector<std::string>> rows = {head_row(study)};
  for (const char* name : {"outcome", "strain", "work [mJ]", "of it friction", "kinetic / internal", "balance",
                           "penetration / D", "steps", "time [s]"}) {
    rows.front().emplace_back(name);
  }
  for (const VariantState& state : states) {
    std::vector<std::string> row = row_of(study, state);
    row.push_back(standing_cell(state));
    const auto share = [&](const char* name) {
      const auto value = measure(state, name);
      return value ? base::percent_text(*value) : "";
    };
    const auto work = measure(state, "work_mJ"), friction = measure(state, "friction_loss_mJ");
    row.push_back(share("strain"));
    row.push_back(number_text(work));
    row.push_back(work && friction && *work > 0 ? base::percent_text(*friction / *work) : "");
    for (const char* name : {"kinetic_ratio", "energy_balance", "penetration_ratio"}) row.push_back(share(name));
    for (const char* name : {"steps", "wall_s"}) row.push_back(number_text(measure(state, name)));
    rows.push_back(std::move(row));
  }
  return report::table(rows);
}

std::string tables_at_strains(const Study& study, const std::vector<VariantState>& states) {
  const VariantState* reference = reference_of(study, states);
  if (reference == nullptr || study.strains.empty()) return {};
  const std::string against =
      fmt::format("<p class=\"soft\">The second number is the difference from the run {}.</p>\n",
                  base::in_markup(reference->variant.name));
  return against + "<h3>Work [mJ]</h3>\n" + table_at_strains(study, states, "work_mJ", *reference) +
         "<h3>Force [N], mean over the 1 % of strain before</h3>\n" +
         table_at_strains(study, states, "force_N", *reference) + "<h3>Width [mm]</h3>\n" +
         table_at_strains(study, states, "width_mm", *reference);
}

std::vector<model::Frame> frames_of(const Study& study, const results::StoredRun& run) {
  std::set<int> indices;
  for (const double strain : study.strains) indices.insert(results::nearest_frame(run, strain).index);
  std::vector<model::Frame> frames;
  frames.reserve(indices.size());
  for (const int index : indices) frames.push_back(results::read_frame(run, index));
  return frames;
}

std::string table_of_shapes(const Study& study, const std::vector<VariantState>& states) {
  std::vector<std::vector<std::string>> rows = {head_row(study)};
  for (const char* name : {"strain", "lowest z [mm]", "highest z [mm]", "contacts", "of them in the middle third",
                           "of their force there"}) {
    rows.front().emplace_back(name);
  }
  const auto share = [](const std::optional<double>& value) { return value ? base::percent_text(*value) : ""; };
  for (const VariantState& state : states) {
    if (!is_completed(state)) continue;
    const results::StoredRun run = results::read_run(state.folder);
    for (const model::Frame& frame : frames_of(study, run)) {
      const results::FrameMeasures measures = results::measure_frame(frame);
      std::vector<std::string> row = row_of(study, state);
      row.push_back(base::percent_text(measures.strain));
      row.push_back(fmt::format("{:.3f}", measures.lowest_z));
      row.push_back(fmt::format("{:.3f}", measures.highest_z));
      row.push_back(fmt::format("{}", measures.contacts));
      row.push_back(share(measures.contacts_in_middle));
      row.push_back(share(measures.force_in_middle));
      rows.push_back(std::move(row));
    }
  }
  return report::table(rows);
}

std::string table_of_comparisons(const Study& study, const std::vector<ComparedState>& compared) {
  if (compared.empty()) return {};
  std::vector<std::vector<std::string>> rows = {head_row(study)};
  for (const char* name :
       {"RMS [N/mm]", "of the largest force", "within the range", "slack taken away", "initial slope [N/mm]",
        "measured", "locking at", "measured", "slope after [N/mm]", "measured", "work ratio"}) {
    rows.front().emplace_back(name);
  }
  for (const auto& [state, comparison] : compared) {
    rows.push_back(comparison_row(row_of(study, *state), comparison));
  }
  return report::table(rows);
}

}  // namespace knitmech::study
