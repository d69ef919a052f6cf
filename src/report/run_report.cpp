#include "report/run_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/number_text.h"
#include "base/text.h"
#include "model/bending_measure.h"
#include "model/facts.h"
#include "model/parameters.h"
#include "model/parameters_text.h"
#include "picture/contact_map.h"
#include "picture/side_profile.h"
#include "report/figures.h"
#include "report/frame_pictures.h"
#include "report/page.h"
#include "report/run_charts.h"
#include "results/atomic_file.h"
#include "results/curve_measures.h"
#include "results/curve_stages.h"
#include "results/frame_measures.h"
#include "results/read_frame.h"
#include "results/summary.h"

namespace knitmech::report {
namespace {

namespace fs = std::filesystem;
using results::StoredRun;

constexpr int kPictureHeight = 800;  // [px]

/// The frames that are shown: all, or some of them that are evenly spaced in strain, the last among them.
std::vector<model::Frame> shown_frames(const StoredRun& run) {
  const std::size_t n_most = std::clamp(kMostNodesShown / run.model.nodes.size(), std::size_t{1}, kMostFrames);
  std::set<int> indices = {run.frames.back().index};
  for (std::size_t i = 0; i + 1 < n_most; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n_most - 1);
    indices.insert(results::nearest_frame(run, share * run.frames.back().strain).index);
  }
  if (run.frames.size() <= n_most) {
    for (const results::StoredFrame& frame : run.frames) indices.insert(frame.index);
  }
  std::vector<model::Frame> frames;
  frames.reserve(indices.size());
  for (const int index : indices) frames.push_back(results::read_frame(run, index));
  return frames;
}

std::string number_html(const std::string& value, const std::string& name) {
  return fmt::format("<div><b>{}</b><span>{}</span></div>", base::in_markup(value), base::in_markup(name));
}

std::string verdict_html(const StoredRun& run) {
  const results::RunSummary& summary = run.summary;
  const bool is_good = summary.quality && summary.quality->quasi_static;
  std::string text = base::in_markup(summary.quality ? summary.quality->verdict : "The run has not ended.");
  if (!summary.reason.empty()) text += " " + base::in_markup(summary.reason);
  if (!summary.advice.empty()) text += " " + base::in_markup(summary.advice);
  return fmt::format("<p class=\"verdict{}\">{}</p>\n", is_good ? "" : " bad", text);
}

std::string head_html(const StoredRun& run) {
  std::string html = verdict_html(run);
  if (run.history.empty()) return html;
  const model::HistoryRow& last = run.history.back();
  html += "<div class=\"numbers\">";
  html += number_html(base::percent_text(last.strain), "strain reached");
  html += number_html(base::force_text(last.force_top), "force at the end");
  html += number_html(fmt::format("{:.4g} mJ", last.external_work), "work of the grip");
  if (last.external_work > 0) {
    html += number_html(base::percent_text(last.friction_loss / last.external_work), "of it lost to friction");
  }
  html += number_html(base::percent_text(1 - last.width / run.history.front().width), "contraction of the width");
  html += number_html(fmt::format("{}", last.contacts), "contacts at the end");
  return html + "</div>\n";
}

/// A chart over strain with the ends of the stages.
picture::Chart with_stages(picture::Chart chart, const results::CurveStages& stages) {
  for (const results::CurveStage& stage : stages.stages) chart.limits.push_back({100 * stage.to, stage.name});
  return chart;
}

std::string stages_table(const results::CurveStages& stages) {
  std::vector<std::vector<std::string>> rows = {{"stage", "from", "to", "slope [N]", "slope per width [N/mm]"}};
  const auto number = [](const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : ""; };
  for (const results::CurveStage& stage : stages.stages) {
    rows.push_back({stage.name, base::percent_text(stage.from), base::percent_text(stage.to), number(stage.slope),
                    number(stage.slope_per_width)});
  }
  const std::string stretch =
      stages.stretch_strain ? fmt::format("The yarn stretches from {} on.", base::percent_text(*stages.stretch_strain))
                            : "The yarn does not stretch yet: bending takes up most of the growing energy to the end.";
  return table(rows) +
         fmt::format(
             "<p class=\"soft\">Slopes are per unit of strain. In the toe the loops close and slide, then they are "
             "bent round each other, at last the yarn itself stretches. {}</p>\n",
             stretch);
}

std::string measures_table(const StoredRun& run, const std::vector<model::Frame>& frames) {
  std::vector<std::vector<std::string>> rows = {{"strain", "force [N]", "per width [N/mm]", "secant [N/mm]",
                                                 "tangent [N/mm]", "width [mm]", "contraction", "Poisson's ratio"}};
  const auto number = [](const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : ""; };
  for (const model::Frame& frame : frames) {
    const auto measure = results::measure_at(run.history, frame.history.strain);
    if (!measure || measure->strain == 0) continue;
    rows.push_back({base::percent_text(measure->strain), number(measure->force), number(measure->force_per_width),
                    number(measure->secant), number(measure->tangent), number(measure->width),
                    base::percent_text(measure->contraction), number(measure->poissons_ratio)});
  }
  return rows.size() > 1 ? table(rows) : "";
}

std::string curve_section(const StoredRun& run, const std::vector<model::Frame>& frames, const Figures& figures) {
  const std::vector<NamedHistory> runs = {{"", run.history}};
  const results::CurveStages stages = results::curve_stages(run.history, model::bending_measure(run.model));
  return stages_table(stages) + measures_table(run, frames) +
         side_by_side(
             {figures.chart("force-strain", with_stages(force_chart(runs, false), stages),
                            "Force at the driven grip over strain, with the ends of the stages."),
              figures.chart(
                  "force-strain-log", with_stages(force_chart(runs, true), stages),
                  "The same with a logarithmic axis: the toe, in which the loops close, and the climb after it."),
              figures.chart("contraction", contraction_chart(runs), "Contraction of the width at mid-height."),
              figures.chart("contacts", contact_chart(runs), "Places where yarns press on each other.")});
}

std::string fabric_section(const StoredRun& run, const std::vector<model::Frame>& frames, const Figures& figures,
                           int threads) {
  std::string html;
  for (const PictureRow& row : draw_rows(run.model, frames, kPictureHeight, threads)) {
    html += fmt::format("<h3>{}</h3>\n<div class=\"pictures\">\n", row.title);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      html += figures.png(fmt::format("{}-{:04}", row.name, frames[i].index), row.png[i],
                          fmt::format("{} at {}", row.title, base::percent_text(frames[i].history.strain)));
    }
    html += "</div>\n";
  }
  return html;
}

/// The contact zones of all frames that have contacts, and the fabric from the side at the end.
std::string maps_of(const StoredRun& run, const std::vector<model::Frame>& frames, const Figures& figures) {
  if (run.model.nodes.size() > kMostNodesInLines) {
    return "<p class=\"soft\">The fabric is too large for maps of its contacts; <code>knitmech render</code> draws "
           "parts of "
           "it.</p>\n";
  }
  std::vector<std::string> maps;
  std::string without;
  try {
    for (const model::Frame& frame : frames) {
      const std::string at = base::percent_text(frame.history.strain);
      if (frame.contacts.empty()) {
        without += (without.empty() ? "" : ", ") + at;
        continue;
      }
      maps.push_back(figures.svg(fmt::format("contact-map-{:04}", frame.index),
                                 picture::contact_map_svg(run.model, frame, fmt::format("Contacts at {}", at)),
                                 fmt::format("Contact zones at {}: discs as large as the normal force.", at)));
    }
    const model::Frame& last = frames.back();
    const std::string at = base::percent_text(last.history.strain);
    maps.push_back(figures.svg(fmt::format("side-profile-{:04}", last.index),
                               picture::side_profile_svg(run.model, last, fmt::format("From the side, at {}", at)),
                               "How far the fabric leaves its plane."));
  } catch (const InputError& error) {
    // The yarns of a run that has failed may be scattered.
    maps.push_back(figure("", error.what()));
  }
  const std::string none = fmt::format("<p class=\"soft\">No yarns press on each other at {}.</p>\n", without);
  return (without.empty() ? "" : none) + side_by_side(maps);
}

std::string width_profile(const StoredRun& run, const std::vector<model::Frame>& frames, const Figures& figures) {
  if (!run.model.has_stitches) {
    return "<p class=\"soft\">The fabric was read from a file, which does not say what its courses and wales are: "
           "there is no width of each course, and places are told by yarn and length along it.</p>\n";
  }
  return side_by_side({figures.chart("width-profile", width_profile_chart(run.model, frames),
                                     "Width of the fabric over its height, at the strains in the legend.")});
}

std::string shape_section(const StoredRun& run, const std::vector<model::Frame>& frames, const Figures& figures) {
  std::vector<std::vector<std::string>> rows = {{"strain", "lowest z [mm]", "highest z [mm]", "contacts",
                                                 "contacts in the middle third", "contact force in the middle third"}};
  const auto share = [](const std::optional<double>& value) { return value ? base::percent_text(*value) : ""; };
  for (const model::Frame& frame : frames) {
    const results::FrameMeasures measures = results::measure_frame(frame);
    rows.push_back({base::percent_text(measures.strain), fmt::format("{:.3f}", measures.lowest_z),
                    fmt::format("{:.3f}", measures.highest_z), fmt::format("{}", measures.contacts),
                    share(measures.contacts_in_middle), share(measures.force_in_middle)});
  }
  return maps_of(run, frames, figures) + width_profile(run, frames, figures) + table(rows) +
         "<p class=\"soft\">If the contacts were spread evenly over the width, a third of them would lie in its middle "
         "third.</p>\n";
}

std::string quality_section(const StoredRun& run, const Figures& figures) {
  std::string html =
      side_by_side({figures.chart("energies", energy_chart(run.history),
                                  "Where the work of the grip went. The run is quasi-static where motion "
                                  "is a small part of it.")});
  if (!run.summary.quality) return html;
  const results::Quality& quality = *run.summary.quality;
  const auto ratio = [](const std::optional<double>& value) { return value ? base::percent_text(*value) : ""; };
  html +=
      table({{"", "value", "limit", "at strain"},
             {"kinetic over internal energy, largest over 1 % strain", ratio(quality.kinetic_ratio), "5 %",
              ratio(quality.kinetic_ratio_strain)},
             {"energy that is not accounted for, over the work", ratio(quality.energy_balance), "1 %",
              ratio(quality.energy_balance_strain)},
             {"difference of the two grip forces, largest over 1 % strain", ratio(quality.grip_difference), "5 %",
              ratio(quality.grip_difference_strain)},
             {"largest penetration over the yarn diameter", base::percent_text(quality.penetration_ratio), "", ""},
             {"largest elastic slip over the yarn diameter", base::percent_text(quality.elastic_slip_ratio), "", ""},
             {"yarns that passed through each other", fmt::format("{}", quality.lost_crossings), "0", ""},
             {"end of the toe region, before which nothing is judged", "", "", ratio(quality.toe_strain)}});
  return html;
}

/// Where something is, in three cells; of a fabric whose stitches are not known in two.
std::vector<std::string> place_cells(const StoredRun& run, const results::YarnPlace& place) {
  if (!run.model.has_stitches) return {fmt::format("{}", place.yarn + 1), fmt::format("{:.4g}", place.arc_length)};
  return {fmt::format("{}", place.course), place.wale ? fmt::format("{}", *place.wale) : "",
          base::in_markup(place.part)};
}

std::string peaks_section(const StoredRun& run) {
  std::vector<std::vector<std::string>> rows = {{"largest in the yarns", "value", "at strain"}};
  const std::vector<std::string> of_place = run.model.has_stitches ? std::vector<std::string>{"course", "wale", "part"}
                                                                   : std::vector<std::string>{"yarn", "along it [mm]"};
  rows.front().insert(rows.front().end(), of_place.begin(), of_place.end());
  for (std::size_t i = 0; i < results::kPeakFields.size(); ++i) {
    const auto& peak = run.summary.largest_in_yarns.at(i);
    if (!peak) continue;
    rows.push_back(
        {results::kPeakFields.at(i).key, fmt::format("{:.4g}", peak->value), base::percent_text(peak->strain)});
    const std::vector<std::string> place = place_cells(run, peak->place);
    rows.back().insert(rows.back().end(), place.begin(), place.end());
  }
  return rows.size() > 1 ? table(rows) : "";
}

std::string parameter_table(const StoredRun& run) {
  std::vector<std::vector<std::string>> rows = {{"parameter", "symbol", "value", "meaning"}};
  for (const model::Parameter& parameter : model::parameters()) {
    const model::Value value = model::value_in(run.input, parameter);
    const bool not_given = parameter.need == model::Need::optional && std::holds_alternative<std::monostate>(value);
    if (not_given || !model::applies_to(parameter, run.input)) continue;
    // A space keeps numbers and words of this column on one side.
    rows.push_back({fmt::format("<code>{}</code>", base::in_markup(parameter.key)), base::in_markup(parameter.symbol),
                    "<code>" + base::in_markup(model::toml_text(parameter, value)) + "</code>",
                    base::in_markup(parameter.help)});
  }
  return table(rows);
}

std::string model_section(const StoredRun& run) {
  const model::FabricFacts facts = model::describe(run.input, run.model);
  std::vector<std::vector<std::string>> rows = {
      {"model", "value"},
      {"size", fmt::format("{:.4g} x {:.4g} x {:.3g} mm, {:.4g} g/m²", facts.width, facts.height, facts.thickness,
                           facts.mass_per_area)},
      {facts.file ? "yarn from turn to turn and back" : "yarn in a stitch",
       fmt::format("{:.5g} mm", facts.stitch_length)},
      {"yarn in the fabric", fmt::format("{:.4g} m", facts.yarn_length / 1000)},
      {"elements, nodes", fmt::format("{}, {}", facts.n_elements, facts.n_nodes)},
      {"stiffness of the yarn",
       fmt::format("EA {:.4g} N, EI {:.4g} N mm², GJ {:.4g} N mm²", facts.section.axial_stiffness,
                   facts.section.bending_stiffness, facts.section.torsional_stiffness)}};
  if (run.summary.mass_scaling) rows.push_back({"mass scaling", fmt::format("{:.4g}", *run.summary.mass_scaling)});
  if (run.summary.steps) rows.push_back({"steps", fmt::format("{}", *run.summary.steps)});
  if (run.summary.wall_seconds) rows.push_back({"took", base::duration_text(*run.summary.wall_seconds)});
  return table(rows) + parameter_table(run);
}

std::string structure_of(const StoredRun& run) {
  const model::Parameter& structure = *model::find_parameter("fabric.structure");
  return std::get<std::string>(model::value_in(run.input, structure));
}

/// What the fabric is, under the title.
std::string fabric_line(const StoredRun& run) {
  const std::string fabric = model::fabric_text(run.input);
  if (!run.model.has_stitches) return fmt::format("{}, {} elements", fabric, run.model.n_elements());
  return fmt::format("{}, {} elements per half stitch, structure {}", fabric, run.input.fabric.elements_per_erc,
                     structure_of(run));
}

std::string footer_html(const StoredRun& run) {
  return fmt::format("Made by KnitMech {}. To repeat it: <code>knitmech run {}</code> with the case of this folder.",
                     base::in_markup(run.summary.program_version), base::in_markup((run.dir / "case.toml").string()));
}

}  // namespace

void remove_run_report(const fs::path& run_folder) {
  try {
    if (!results::is_summary(run_folder / results::kSummaryFile)) return;
    fs::remove(run_folder / kReportFile);
    const fs::path figures = run_folder / kFiguresFolder;
    if (!fs::is_directory(figures)) return;
    std::vector<fs::path> ours;
    for (const fs::directory_entry& entry : fs::directory_iterator(figures)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".svg" || extension == ".png") ours.push_back(entry.path());
    }
    for (const fs::path& file : ours) fs::remove(file);
    if (fs::is_empty(figures)) fs::remove(figures);
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("cannot remove the report in {}: {}", run_folder.string(), error.code().message()));
  }
}

void write_run_report(const StoredRun& run, int threads) {
  const Figures figures(run.dir / kFiguresFolder);
  const std::vector<model::Frame> frames = shown_frames(run);
  Page page(run.summary.title, fabric_line(run));
  page.add_to_head(head_html(run));
  page.add_section("Force and strain", curve_section(run, frames, figures));
  page.add_section("The fabric", fabric_section(run, frames, figures, threads));
  page.add_section("Shape and contact", shape_section(run, frames, figures));
  page.add_section("Quality", quality_section(run, figures) + peaks_section(run));
  page.add_section("The model", model_section(run));
  results::write_file_atomically(run.dir / kReportFile, page.html(footer_html(run)));
}

}  // namespace knitmech::report
