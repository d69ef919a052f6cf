#include "study/study_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/errors.h"
#include "base/number_text.h"
#include "base/quantity.h"
#include "picture/comparison_chart.h"
#include "report/figures.h"
#include "report/frame_pictures.h"
#include "report/page.h"
#include "report/run_charts.h"
#include "results/atomic_file.h"
#include "results/frame_measures.h"
#include "results/history_file.h"
#include "results/read_frame.h"
#include "results/read_run.h"
#include "study/compare_runs.h"

namespace knitmech::study {
namespace {

namespace fs = std::filesystem;
using report::Figures;
using report::NamedHistory;

/// Lines in a chart that a legend can still tell apart, and rows of pictures on a page [-].
constexpr std::size_t kMostNamedLines = 6, kMostPictureRows = 8;
constexpr int kPictureHeight = 700;  // [px]
constexpr int kDigits = 5;

bool is_completed(const VariantState& state) {
  return state.standing == Standing::completed;
}

/// "elements_per_erc = 10, friction = 0.1"
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

std::string number_text(const std::optional<double>& value) {
  constexpr double kLongNumber = 1e4;
  if (!value) return {};
  const bool is_long_count = std::abs(*value) >= kLongNumber && *value == std::round(*value);
  return is_long_count ? fmt::format("{:.0f}", *value) : fmt::format("{:.4g}", *value);
}

/// What stands above a column of the values of a variation.
std::string head_of(const Variation& variation) {
  return fmt::format("<code>{}</code>", report::escaped(model::name_of(variation.parameter->key)));
}

/// A row of a table that begins with the values of a variant.
std::vector<std::string> row_of(const Study& study, const VariantState& state) {
  std::vector<std::string> row = {report::escaped(state.variant.name)};
  for (std::size_t i = 0; i < study.variations.size(); ++i) {
    row.push_back(report::escaped(value_text(*study.variations[i].parameter, state.variant.values[i], kDigits)));
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
    return fmt::format("<span class=\"bad\">{}</span> {}", name_of(state.standing), report::escaped(state.reason));
  }
  return measure(state, "quasi_static") == 1.0 ? "<span class=\"good\">quasi-static</span>"
                                               : "<span class=\"bad\">not quasi-static</span>";
}

std::string table_section(const Study& study, const std::vector<VariantState>& states) {
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

std::vector<NamedHistory> histories_of(const Study& study, const std::vector<VariantState>& states) {
  std::vector<NamedHistory> runs;
  for (const VariantState& state : states) {
    if (!is_completed(state)) continue;
    runs.push_back({title_of(study, state.variant), results::read_history(state.folder / results::kHistoryFile)});
  }
  if (runs.size() > kMostNamedLines) {
    for (NamedHistory& run : runs) run.name.clear();
  }
  return runs;
}

std::string curves_section(const Study& study, const std::vector<VariantState>& states, const Figures& figures) {
  const std::vector<NamedHistory> runs = histories_of(study, states);
  if (runs.empty()) return "<p>No run is completed.</p>\n";
  return report::side_by_side(
      {figures.chart("force-strain", force_chart(runs, false), "Force at the driven grip over strain."),
       figures.chart("force-strain-log", force_chart(runs, true), "The same with a logarithmic axis."),
       figures.chart("work", work_chart(runs), "Work of the grip: the area below the curve, smoother than the curve."),
       figures.chart("contraction", contraction_chart(runs), "Contraction of the width at mid-height."),
       figures.chart("contacts", contact_chart(runs), "Places where yarns press on each other.")});
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

std::string strains_section(const Study& study, const std::vector<VariantState>& states) {
  const VariantState* reference = reference_of(study, states);
  if (reference == nullptr || study.strains.empty()) return {};
  const std::string against =
      fmt::format("<p class=\"soft\">The second number is the difference from the run {}.</p>\n",
                  report::escaped(reference->variant.name));
  return against + "<h3>Work [mJ]</h3>\n" + table_at_strains(study, states, "work_mJ", *reference) +
         "<h3>Force [N], mean over the 1 % of strain before</h3>\n" +
         table_at_strains(study, states, "force_N", *reference) + "<h3>Width [mm]</h3>\n" +
         table_at_strains(study, states, "width_mm", *reference);
}

/// Each run beside the measured curves: error measures, and the overlay of all in force per width.
std::string measured_section(const Study& study, const std::vector<VariantState>& states, const Figures& figures) {
  std::vector<std::vector<std::string>> rows = {head_row(study)};
  for (const char* name :
       {"RMS [N/mm]", "of the largest force", "within the range", "slack taken away", "initial slope [N/mm]",
        "measured", "locking at", "measured", "slope after [N/mm]", "measured", "work ratio"}) {
    rows.front().emplace_back(name);
  }
  std::vector<std::string> charts;
  std::string troubles;
  for (const VariantState& state : states) {
    if (!is_completed(state)) continue;
    try {
      const compare::Comparison comparison = compare_run(state.folder, *study.measured);
      rows.push_back(comparison_row(row_of(study, state), comparison));
      if (charts.size() == kMostPictureRows) continue;
      charts.push_back(figures.chart("measured-" + state.variant.name,
                                     picture::comparison_chart(comparison, title_of(study, state.variant), 0),
                                     "Force per width, simulated and measured."));
    } catch (const InputError& error) {
      troubles += fmt::format("<p class=\"bad\">{}: {}</p>\n", report::escaped(state.variant.name),
                              report::escaped(error.what()));
    }
  }
  return troubles + (rows.size() > 1 ? report::table(rows) : "") + report::side_by_side(charts);
}

/// A value on an axis, in the unit that values of its parameter are written in; empty for a word.
std::optional<double> number_on_axis(const model::Parameter& parameter, const model::Value& value) {
  if (const auto* whole = std::get_if<int>(&value)) return *whole;
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr) return std::nullopt;
  const auto units = base::units_of(parameter.dimension);
  return units.empty() ? *number : *number * units.front().divide / units.front().multiply;
}

/// Work at the largest strain over the values of one parameter: one line if nothing else varies, or else marks. Of a
/// plan that varies one at a time only the runs that have their base value in all others.
std::optional<picture::Chart> effect_chart(const Study& study, const std::vector<VariantState>& states,
                                           std::size_t which) {
  const model::Parameter& parameter = *study.variations[which].parameter;
  const auto units = base::units_of(parameter.dimension);
  picture::Chart chart{.x_label = fmt::format("{} [{}]", model::name_of(parameter.key),
                                              units.empty() ? "-" : std::string(units.front().name)),
                       .y_label = fmt::format("Work to {} [mJ]", base::percent_text(study.strains.back())),
                       .width = 640,
                       .height = 440};
  std::vector<std::pair<double, double>> points;
  const Variant& first = states.front().variant;
  for (const VariantState& state : states) {
    const auto x = number_on_axis(parameter, state.variant.values[which]);
    const auto y = measure(state, at("work_mJ", study.strains.back()));
    bool belongs = x.has_value() && y.has_value();
    for (std::size_t i = 0; i < study.variations.size() && study.plan == Plan::one_at_a_time; ++i) {
      belongs = belongs && (i == which || state.variant.values[i] == first.values[i]);
    }
    if (belongs) points.emplace_back(*x, *y);
  }
  if (points.size() < 2) return std::nullopt;
  std::ranges::sort(points);
  const bool is_line = study.variations.size() == 1 || study.plan == Plan::one_at_a_time;
  for (const bool marks : {false, true}) {
    if (!marks && !is_line) continue;
    picture::Series series{"", {}, {}, marks};
    for (const auto& [x, y] : points) {
      series.x.push_back(x);
      series.y.push_back(y);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::string effects_section(const Study& study, const std::vector<VariantState>& states, const Figures& figures) {
  if (study.strains.empty() || states.empty()) return {};
  std::vector<std::string> charts;
  for (std::size_t i = 0; i < study.variations.size(); ++i) {
    const std::string key = study.variations[i].parameter->key;
    const auto chart = effect_chart(study, states, i);
    if (chart) charts.push_back(figures.chart("effect-" + key, *chart, fmt::format("What {} does to the work.", key)));
  }
  return charts.empty() ? "" : report::side_by_side(charts);
}

/// The stored frames of a run nearest to the strains of the study, each once.
std::vector<model::Frame> frames_of(const Study& study, const results::StoredRun& run) {
  std::set<int> indices;
  for (const double strain : study.strains) indices.insert(results::nearest_frame(run, strain).index);
  std::vector<model::Frame> frames;
  for (const int index : indices) frames.push_back(results::read_frame(run, index));
  return frames;
}

std::string shape_rows(const Study& study, const std::vector<VariantState>& states) {
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

std::string pictures_of(const Study& study, const VariantState& state, const Figures& figures) {
  const results::StoredRun run = results::read_run(state.folder);
  const std::vector<model::Frame> frames = frames_of(study, run);
  std::string html =
      fmt::format("<h3>{}</h3>\n<div class=\"pictures\">\n", report::escaped(title_of(study, state.variant)));
  for (const model::Frame& frame : frames) {
    html += figures.png(fmt::format("{}-{:04}", state.variant.name, frame.index),
                        report::draw_contact(run.model, frame, kPictureHeight, 0),
                        fmt::format("Contact force at {}", base::percent_text(frame.history.strain)));
  }
  return html + "</div>\n";
}

std::string fabrics_section(const Study& study, const std::vector<VariantState>& states, const Figures& figures) {
  std::string html;
  std::size_t n_rows = 0;
  for (const VariantState& state : states) {
    if (!is_completed(state)) continue;
    if (n_rows++ == kMostPictureRows) {
      return html + fmt::format(
                        "<p class=\"soft\">The other runs are not shown; <code>knitmech report</code> makes the "
                        "report of any of them.</p>\n");
    }
    html += pictures_of(study, state, figures);
  }
  return html;
}

std::string head_html(const std::vector<VariantState>& states) {
  std::string text;
  for (const Standing standing : {Standing::completed, Standing::failed, Standing::impossible, Standing::pending}) {
    const auto n = std::ranges::count(states, standing, &VariantState::standing);
    if (n > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, name_of(standing));
  }
  const bool is_good = std::ranges::all_of(
      states, [](const VariantState& state) { return is_completed(state) && measure(state, "quasi_static") == 1.0; });
  return fmt::format("<p class=\"verdict{}\">{} runs: {}. {}</p>\n", is_good ? "" : " bad", states.size(), text,
                     is_good ? "All are quasi-static: their energy balance, their motion and their grip forces are "
                               "within the limits."
                             : "Not all runs are completed and quasi-static; see the table.");
}

}  // namespace

void write_study_report(const fs::path& folder, const Study& study, const std::vector<VariantState>& states) {
  const Figures figures(folder / "figures");
  report::Page page(study.title, fmt::format("Base case: {}, {} wales x {} courses", study.base.title,
                                             study.base.fabric.wales, study.base.fabric.courses));
  page.add_to_head(head_html(states));
  page.add_section("Runs", table_section(study, states));
  page.add_section("Curves", curves_section(study, states, figures));
  page.add_section("At the same strain", strains_section(study, states));
  if (study.measured) page.add_section("Beside measurements", measured_section(study, states, figures));
  const std::string effects = effects_section(study, states, figures);
  if (!effects.empty()) page.add_section("Effects", effects);
  page.add_section("Shape and contact", shape_rows(study, states));
  page.add_section("Fabrics", fabrics_section(study, states, figures));
  results::write_file_atomically(
      folder / kStudyReportFile,
      page.html(fmt::format("Made by KnitMech {}. To repeat it: <code>knitmech study {}</code>", KNITMECH_VERSION,
                            report::escaped(study.file.string()))));
}

}  // namespace knitmech::study
