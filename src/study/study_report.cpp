#include "study/study_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/errors.h"
#include "base/number_text.h"
#include "base/quantity.h"
#include "base/text.h"
#include "model/facts.h"
#include "picture/comparison_chart.h"
#include "report/figures.h"
#include "report/frame_pictures.h"
#include "report/page.h"
#include "report/run_charts.h"
#include "results/atomic_file.h"
#include "results/history_file.h"
#include "results/read_run.h"
#include "study/compare_runs.h"
#include "study/study_tables.h"

namespace knitmech::study {
namespace {

namespace fs = std::filesystem;
using report::Figures;
using report::NamedHistory;

/// Lines in a chart that a legend can still tell apart, and rows of pictures on a page [-].
constexpr std::size_t kMostNamedLines = 6, kMostPictureRows = 8;
constexpr int kPictureHeight = 700;  // [px]

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

/// Each run beside the measured curves: error measures, and the overlays in force per width.
std::string measured_section(const Study& study, const std::vector<VariantState>& states, const Figures& figures) {
  std::vector<ComparedState> compared;
  std::string troubles;
  for (const VariantState& state : states) {
    if (!is_completed(state)) continue;
    try {
      compared.emplace_back(&state, compare_run(state.folder, *study.measured));
    } catch (const InputError& error) {
      troubles += fmt::format("<p class=\"bad\">{}: {}</p>\n", base::in_markup(state.variant.name),
                              base::in_markup(error.what()));
    }
  }
  std::vector<std::string> charts;
  for (const auto& [state, comparison] : compared) {
    if (charts.size() == kMostPictureRows) break;
    charts.push_back(figures.chart("measured-" + state->variant.name,
                                   picture::comparison_chart(comparison, title_of(study, state->variant), 0),
                                   "Force per width, simulated and measured."));
  }
  return troubles + table_of_comparisons(study, compared) + report::side_by_side(charts);
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

std::string pictures_of(const Study& study, const VariantState& state, const Figures& figures) {
  const results::StoredRun run = results::read_run(state.folder);
  const std::vector<model::Frame> frames = frames_of(study, run);
  std::string html =
      fmt::format("<h3>{}</h3>\n<div class=\"pictures\">\n", base::in_markup(title_of(study, state.variant)));
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
  report::Page page(study.title, fmt::format("Base case: {}, {}", study.base.title, model::fabric_text(study.base)));
  page.add_to_head(head_html(states));
  page.add_section("Runs", table_of_runs(study, states));
  page.add_section("Curves", curves_section(study, states, figures));
  page.add_section("At the same strain", tables_at_strains(study, states));
  if (study.measured) page.add_section("Beside measurements", measured_section(study, states, figures));
  const std::string effects = effects_section(study, states, figures);
  if (!effects.empty()) page.add_section("Effects", effects);
  page.add_section("Shape and contact", table_of_shapes(study, states));
  page.add_section("Fabrics", fabrics_section(study, states, figures));
  results::write_file_atomically(
      folder / kStudyReportFile,
      page.html(fmt::format("Made by KnitMech {}. To repeat it: <code>knitmech study {}</code>", KNITMECH_VERSION,
                            base::in_markup(study.file.string()))));
}

}  // namespace knitmech::study
