#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/json_text.h"
#include "app/progress.h"
#include "app/run_texts.h"
#include "compare/comparison_files.h"
#include "model/bending_measure.h"
#include "model/facts.h"
#include "report/run_report.h"
#include "results/atomic_file.h"
#include "results/curve_stages.h"
#include "results/read_run.h"
#include "results/summary.h"
#include "run/run_case.h"
#include "run/run_start.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;

std::string paths_text(const fs::path& folder, bool pictures, bool report) {
  std::string text =
      fmt::format("Results: {}\n  history.csv, summary.json, frames/frames.pvd (for ParaView)", folder.string());
  if (pictures) text += ",\n  pictures/force-strain.svg, pictures/frame_*.png";
  if (report) text += ",\n  report.html (opens in a browser), figures/";
  return text + "\n";
}

void report_early_end(const model::RunOutcome& outcome, const fs::path& folder) {
  const std::string kept = fmt::format("what was computed is kept in {}", folder.string());
  if (outcome.status == model::RunStatus::interrupted) {
    fmt::print(stderr, "knitmech: interrupted at {} strain; {}; to go on: knitmech run --resume {}\n",
               percent_text(outcome.strain), kept, folder.string());
  } else {
    fmt::print(stderr, "knitmech: error: {} {} {}\n", outcome.reason, outcome.advice, "W" + kept.substr(1) + ".");
  }
}

void print_head(const run::RunStart& start, const solve::SimulationSettings& settings) {
  const model::FabricFacts facts = model::describe(start.loaded.input, start.loaded.model);
  fmt::print("{}", run_head_text(start.loaded, facts, *settings.mass_scaling, *settings.threads, start.folder,
                                 start.resumed_at()));
  std::fflush(stdout);
}

/// Reports and comparisons would be taken for those of the run that begins.
void remove_what_shows_an_earlier_run(const run::RunStart& start) {
  if (start.checkpoint || !results::is_summary(start.folder / results::kSummaryFile)) return;
  report::remove_run_report(start.folder);
  compare::remove_comparison(start.folder);
}

run::RunResult run_with_progress(run::RunStart& start, const run::RunSettings& settings, bool talks) {
  const InterruptWatch watch;
  Progress progress(start.loaded.model.test, start.resumed_at().value_or(0), talks);
  run::RunListener listener;
  listener.on_history = [&](const model::HistoryRow& row) { progress.update(row); };
  listener.keep_going = [] { return !InterruptWatch::requested(); };
  run::RunResult result = run::run_case(start, settings, listener);
  progress.finish();
  return result;
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  run::RunStart start =
      options.resume.empty() ? run::new_run(options.case_file, options.folder) : run::earlier_run(options.resume);
  const model::Model& model = start.loaded.model;
  const run::RunSettings settings{run::resolved_settings(start.loaded, options.threads), options.pictures};
  const fs::path& folder = start.folder;
  const bool talks = !options.quiet && !options.json;

  remove_what_shows_an_earlier_run(start);
  if (talks) print_head(start, settings.simulation);
  const run::RunResult result = run_with_progress(start, settings, talks);
  const bool has_report = options.pictures && result.outcome.status != model::RunStatus::interrupted;
  if (has_report) report::write_run_report(results::read_run(folder));
  if (talks) {
    const auto stages = results::curve_stages(result.history, model::bending_measure(model));
    fmt::print("{}{}", run_end_text(model, result.outcome, result.history.back(), result.quality, stages),
               paths_text(folder, options.pictures, has_report));
  }
  if (options.json) fmt::print("{}\n", run_json(results::read_file(folder / "summary.json"), folder));
  std::fflush(stdout);
  if (result.outcome.status == model::RunStatus::completed) return kDone;
  if (!options.json) report_early_end(result.outcome, folder);
  return kNotFinished;
}

}  // namespace knitmech::app
