#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/json_text.h"
#include "app/load_case.h"
#include "app/progress.h"
#include "app/run_pictures.h"
#include "app/run_texts.h"
#include "model/case_file.h"
#include "model/facts.h"
#include "results/atomic_file.h"
#include "results/quality.h"
#include "results/run_folder.h"
#include "solve/mass_scaling.h"
#include "solve/simulate.h"
#include "solve/threads.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;

/// results/jersey for some/where/jersey.toml; results/where for some/where/case.toml.
fs::path default_folder(const fs::path& case_file) {
  const fs::path whole = fs::absolute(case_file).lexically_normal();
  const bool named_by_folder = whole.filename() == "case.toml" && whole.parent_path().has_filename();
  const fs::path name = named_by_folder ? whole.parent_path().filename() : whole.stem();
  return "results" / name;
}

solve::SimulationSettings resolved_settings(const LoadedCase& loaded, std::optional<int> threads) {
  solve::SimulationSettings settings = solve::settings_from(loaded.input);
  if (!settings.mass_scaling) settings.mass_scaling = solve::automatic_mass_scaling(loaded.model);
  settings.threads = threads ? *threads : solve::automatic_threads(loaded.model);
  return settings;
}

/// The simulation of a model with everything that listens to it.
model::RunOutcome simulate_into(results::RunFolder& folder, RunPictures& pictures, Progress& progress,
                                const model::Model& model, const solve::SimulationSettings& settings) {
  const InterruptWatch watch;
  solve::SimulationCallbacks callbacks;
  callbacks.on_history = [&](const model::HistoryRow& row) {
    folder.add_history(row);
    progress.update(row);
  };
  callbacks.on_frame = [&](const model::Frame& frame) {
    folder.add_frame(frame);
    pictures.add_frame(frame);
  };
  callbacks.keep_going = [](const model::HistoryRow&) { return !InterruptWatch::requested(); };
  model::RunOutcome outcome = solve::simulate(model, settings, callbacks);
  progress.finish();
  folder.finish(outcome);
  pictures.finish(folder.history());
  return outcome;
}

std::string paths_text(const fs::path& folder, bool pictures) {
  std::string text =
      fmt::format("Results: {}\n  history.csv, summary.json, frames/frames.pvd (for ParaView)", folder.string());
  if (pictures) text += ",\n  pictures/force-strain.svg, pictures/frame_*.png";
  return text + "\n";
}

void report_early_end(const model::RunOutcome& outcome, const fs::path& folder) {
  const std::string kept = fmt::format("what was computed is kept in {}", folder.string());
  if (outcome.status == model::RunStatus::interrupted) {
    fmt::print(stderr, "knitmech: interrupted at {} strain; {}\n", percent_text(outcome.strain), kept);
  } else {
    fmt::print(stderr, "knitmech: error: {} {} {}\n", outcome.reason, outcome.advice, "W" + kept.substr(1) + ".");
  }
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  const LoadedCase loaded = load_case(options.case_file);
  const model::Model& model = loaded.model;
  const solve::SimulationSettings settings = resolved_settings(loaded, options.threads);
  const fs::path folder = options.folder.empty() ? default_folder(options.case_file) : fs::path(options.folder);
  const bool talks = !options.quiet && !options.json;

  if (talks) {
    const model::FabricFacts facts = model::describe(loaded.input, model);
    fmt::print("{}", run_head_text(loaded, facts, *settings.mass_scaling, *settings.threads, folder));
    std::fflush(stdout);
  }
  results::RunFolder results(folder, model::write_case(loaded.input), model);
  RunPictures pictures(results, model, options.pictures);
  Progress progress(model.test, talks);
  const model::RunOutcome outcome = simulate_into(results, pictures, progress, model, settings);

  const auto quality = results::assess_quality(results.history(), outcome, model.sections.front().diameter);
  if (talks) {
    fmt::print("{}{}", run_end_text(model, outcome, results.history().back(), quality),
               paths_text(folder, options.pictures));
  }
  if (options.json) fmt::print("{}\n", run_json(results::read_file(folder / "summary.json"), folder));
  std::fflush(stdout);
  if (outcome.status == model::RunStatus::completed) return kDone;
  if (!options.json) report_early_end(outcome, folder);
  return kNotFinished;
}

}  // namespace knitmech::app
