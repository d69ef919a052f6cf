#include "app/run_texts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "app/structure_texts.h"
#include "base/quantity.h"
#include "model/constants.h"
#include "results/ravelling.h"
#include "results/yarn_breaks.h"
#include "run/run_estimate.h"
#include "solve/mass_scaling.h"

namespace knitmech::app {
namespace {

std::string counts_text(const model::FabricFacts& facts) {
  return fmt::format("{} elements, {} nodes, {} degrees of freedom", facts.n_elements, facts.n_nodes,
                     facts.n_degrees_of_freedom);
}

std::string fabric_text(const model::Case& input, const model::FabricFacts& facts) {
  const std::string fabric = model::fabric_text(input);
  if (!facts.file) return fmt::format("{}, {} elements per half stitch (ERC)", fabric, input.fabric.elements_per_erc);
  return fmt::format("{} with {} points, {}", fabric, facts.file->n_points, input.fabric.yarn_file->path.string());
}

std::string test_text(const model::TensileTest& test, bool adapts_pace) {
  const std::string to =
      fmt::format("wale-wise tension to {} of {:.4g} mm", percent_text(test.strain), test.gauge_length);
  if (adapts_pace) return fmt::format("{} at a speed that is adapted, in measures of {:.4g} mm/s", to, test.speed);
  return fmt::format("{} at {:.4g} mm/s, {:.4g} s", to, test.speed, test.time_at(test.strain));
}

std::string mass_scaling_text(const model::Case& input, double mass_scaling) {
  constexpr double kLeastWhole = 100;
  const std::string factor =
      mass_scaling < kLeastWhole ? fmt::format("{:.3g}", mass_scaling) : fmt::format("{:.0f}", mass_scaling);
  return fmt::format("x {}{}", factor, input.solver.mass_scaling ? "" : " (chosen for the test)");
}

std::string out_of_plane_text(const model::FabricFacts& facts) {
  return fmt::format("{:.5g} /mm{}, the least without overlap is {:.5g} /mm", facts.out_of_plane,
                     facts.automatic_out_of_plane ? " (chosen)" : "", facts.least_out_of_plane);
}

std::string gap_text(const model::FileFacts& facts, double diameter) {
  if (!facts.closest) return fmt::format("none below {:.4g} mm", (model::kGapReach - 1) * diameter);
  const auto place = [](const curves::PlaceOnLine& on) {
    return fmt::format("yarn {} at {:.4g} mm", on.yarn + 1, on.arc_length);
  };
  return fmt::format("{:.4g} mm, between {} and {} of its length", facts.closest->distance - diameter,
                     place(facts.closest->a), place(facts.closest->b));
}

std::string gap_text(const std::optional<knit::Approach>& approach) {
  if (!approach) return "none, no yarn passes near another";
  return fmt::format("{:.4g} mm, between {} and {}", approach->gap, describe(approach->a), describe(approach->b));
}

double degrees(double angle) {
  return angle * 180 / std::numbers::pi;
}

std::string contacts_text(const model::HistoryRow& last, const results::Quality& quality) {
  return fmt::format("{} contacts with {} in all; the largest elastic slip of the run is {} of the yarn diameter",
                     last.contacts, force_text(last.normal_force), percent_text(quality.elastic_slip_ratio));
}

std::string crossings_text(const model::RunOutcome& outcome) {
  if (outcome.lost_crossings > 0) return "one was lost";
  return fmt::format("all kept, no yarn went through another in {} checks", outcome.crossing_checks);
}

using Line = std::pair<const char*, std::string>;

/// "EA that of zero strain, along a measured curve to 20 % and 2.6 N; breaks at 6 N, which ends the test"; empty for a
/// linear yarn that never breaks.
std::string curve_and_strength_text(const model::Model& model) {
  std::vector<std::string> parts;
  if (const auto law = model.axial_laws.find(0); law != model.axial_laws.end()) {
    const double last = law->second.last_strain();
    parts.push_back(fmt::format("EA that of zero strain, along a measured curve to {} and {}", percent_text(last),
                                force_text(law->second.force(last))));
  }
  if (const auto strength = model.strengths.find(0); strength != model.strengths.end()) {
    parts.push_back(fmt::format("breaks at {}{}", force_text(strength->second),
                                model.test.on_break == model::OnBreak::stop ? ", which ends the test" : ""));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

/// The yarn and, where there is one, the edge yarn.
std::vector<Line> yarn_lines(const run::LoadedCase& loaded, const model::FabricFacts& facts) {
  std::vector<Line> lines = {{"yarn", stiffness_text(facts.section)}};
  const auto add_filaments = [&](const model::YarnStiffness& yarn) {
    const std::string filaments = filaments_text(yarn);
    if (!filaments.empty()) lines.emplace_back("", filaments);
  };
  add_filaments(loaded.input.yarn);
  const std::string limits = curve_and_strength_text(loaded.model);
  if (!limits.empty()) lines.emplace_back("", limits);
  if (!facts.edge_section) return lines;
  lines.emplace_back("edge yarn", stiffness_text(*facts.edge_section));
  add_filaments(loaded.input.edge_yarn);
  return lines;
}

std::string contact_text(const run::LoadedCase& loaded, const model::FabricFacts& facts) {
  const model::Model& model = loaded.model;
  const std::string of_edge =
      facts.edge_section ? fmt::format(" (edge yarn {:.3g})", edge_friction(loaded.input)) : std::string();
  return fmt::format("friction {:.3g}{}, {:.4g} N/mm at a crossing", model.friction, of_edge, model.contact_stiffness);
}

std::vector<Line> lines_on_loops(const run::LoadedCase& loaded, const model::FabricFacts& facts) {
  return {{"structure", structure_text(loaded.input, facts)},
          {"mesh", counts_text(facts)},
          {"loop length", fmt::format("{:.5g} mm of yarn in a stitch, {:.4g} m in the fabric", facts.stitch_length,
                                      facts.yarn_length / 1000)},
          {"leg", fmt::format("inclined by {:.4g} degrees at the head and {:.4g} degrees at the foot",
                              degrees(facts.erc.theta1), degrees(facts.erc.theta2))},
          {"out of plane", out_of_plane_text(facts)},
          {"least gap", gap_text(facts.closest_on_curve)},
          {"", "on the elements " + gap_text(facts.closest_on_elements)}};
}

std::vector<Line> lines_on_file(const run::LoadedCase& loaded, const model::FabricFacts& facts) {
  const model::FileFacts& file = *facts.file;
  const double diameter = loaded.input.yarn.diameter;
  std::vector<Line> lines = {
      {"mesh", fmt::format("{}; elements of {:.4g} mm", counts_text(facts), file.element_length)},
      {"yarn length",
       fmt::format("{:.4g} m, {:.4g} mm from a turn along y to the next", facts.yarn_length / 1000, file.half_stitch)},
      {"least gap", gap_text(file, diameter)},
      {"grips", fmt::format("{} nodes in the lowest {:.4g} mm, {} nodes in the highest", file.n_bottom, file.grip_depth,
                            file.n_top)}};
  constexpr double kSameDiameter = 1e-3;
  if (file.diameter_in_file > 0 && std::abs(file.diameter_in_file - diameter) > kSameDiameter * diameter) {
    lines.emplace_back("note",
                       fmt::format("the file gives a yarn diameter of {:.4g} mm, the case {:.4g} mm, which holds",
                                   file.diameter_in_file, diameter));
  }
  return lines;
}

}  // namespace

std::string check_text(const run::LoadedCase& loaded, const model::FabricFacts& facts, double mass_scaling) {
  std::string text = loaded.model.title + "\n";
  const auto add = [&](const char* name, const std::string& value) { text += fmt::format("  {:14}{}\n", name, value); };
  add("fabric", fabric_text(loaded.input, facts));
  for (const auto& [name, value] : facts.file ? lines_on_file(loaded, facts) : lines_on_loops(loaded, facts)) {
    add(name, value);
  }
  add("size", fmt::format("{:.4g} x {:.4g} x {:.3g} mm, {:.4g} g/m^2", facts.width, facts.height, facts.thickness,
                          facts.mass_per_area));
  for (const auto& [name, value] : yarn_lines(loaded, facts)) add(name, value);
  add("contact", contact_text(loaded, facts));
  add("test", test_text(loaded.model.test, solve::adapts_pace(loaded.input, mass_scaling)));
  add("mass scaling", mass_scaling_text(loaded.input, mass_scaling));
  add("run time", fmt::format("about {}", base::duration_text(run::estimate_run(loaded).seconds)));
  return text;
}

std::string run_head_text(const run::LoadedCase& loaded, const model::FabricFacts& facts, double mass_scaling,
                          int threads, const std::filesystem::path& folder, std::optional<double> resumed_at) {
  std::string text = loaded.model.title + "\n";
  const auto add = [&](const char* name, const std::string& value) { text += fmt::format("  {:14}{}\n", name, value); };
  add("fabric", fabric_text(loaded.input, facts));
  if (!facts.file) add("structure", structure_text(loaded.input, facts));
  add("mesh", counts_text(facts));
  add(facts.file ? "half stitch" : "loop length",
      fmt::format("{:.5g} mm", facts.file ? facts.file->half_stitch : facts.stitch_length));
  if (facts.edge_section) {
    add("edge yarn",
        fmt::format("{}, friction {:.3g}", stiffness_text(*facts.edge_section), edge_friction(loaded.input)));
  }
  add("test", test_text(loaded.model.test, solve::adapts_pace(loaded.input, mass_scaling)));
  add("mass scaling", mass_scaling_text(loaded.input, mass_scaling));
  add("threads", std::to_string(threads));
  std::string note;
  if (resumed_at) {
    note = fmt::format(" (goes on from {} strain)", percent_text(*resumed_at));
  } else if (std::filesystem::exists(folder / "summary.json")) {
    note = " (replaces the run that is there)";
  }
  add("results", folder.string() + note);
  return text;
}

std::string stages_text(const results::CurveStages& stages) {
  if (stages.stages.empty()) return {};
  std::string text = "Stages:";
  for (const results::CurveStage& stage : stages.stages) {
    text += fmt::format(" {} to {} strain", stage.name, percent_text(stage.to));
    text += stage.slope_per_width ? fmt::format(", slope {};", per_width_text(*stage.slope_per_width)) : ";";
  }
  if (stages.stretch_strain) {
    return fmt::format("{} the yarn stretches from {} on.\n", text, percent_text(*stages.stretch_strain));
  }
  if (!stages.stretch_share) return text + " the loops have not closed.\n";
  return fmt::format("{} the yarn does not stretch yet ({} of the growth of the strain energy at the end).\n", text,
                     percent_text(*stages.stretch_share));
}

std::string run_end_text(const model::Model& model, const model::RunOutcome& outcome, const model::HistoryRow& last,
                         const results::Quality& quality, const results::CurveStages& stages) {
  const bool reached = outcome.status == model::RunStatus::completed && outcome.reason.empty();
  const char* const how = reached ? "Reached" : "Stopped at";
  const std::string ties = ties_text(model, outcome);
  std::string events;
  for (const std::string& text : {results::breaks_text(model, outcome), results::ravelling_text(model, outcome)}) {
    if (!text.empty()) events += text + "\n";
  }
  return fmt::format("{} {} strain with {} after {} ({} steps).\n{}Contact: {}.\n{}Crossings: {}.\n{}Quality: {}\n",
                     how, percent_text(outcome.strain), force_text(last.force_top), duration_text(outcome.wall_seconds),
                     outcome.steps, stages_text(stages), contacts_text(last, quality), ties.empty() ? "" : ties + "\n",
                     crossings_text(outcome), events, quality.verdict);
}

}  // namespace knitmech::app
