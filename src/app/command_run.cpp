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
#include "app/run_pictures.h"
#include "app/run_start.h"
#include "app/run_texts.h"
#include "model/facts.h"
#include "results/atomic_file.h"
#include "results/checkpoint_writer.h"
#include "results/quality.h"
#include "results/run_folder.h"
#include "solve/mass_scaling.h"
#include "solve/simulate.h"
#include "solve/threads.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;

solve::SimulationSettings resolved_settings(const LoadedCase& loaded, std::optional<int> threads) {
  solve::SimulationSettings settings = solve::settings_from(loaded.input);
  if (!settings.mass_scaling) settings.mass_scaling = solve::automatic_mass_scaling(loaded.model);
  settings.threads = threads ? *threads : solve::automatic_threads(loaded.model);
  return settings;
}

/// The simulation of a case with everything that listens to it.
model::RunOutcome simulate_into(results::RunFolder& folder, RunPictures& pictures, Progress& progress, RunStart& start,
                                const solve::SimulationSettings& settings) {
  const InterruptWatch watch;
  results::CheckpointWriter writer(folder.path(), start.loaded.input.output.checkpoint_every);
  solve::SimulationCallbacks callbacks;
  callbacks.on_history = [&](const model::HistoryRow& row) {
    folder.add_history(row);
    progress.update(row);
  };
  callbacks.on_frame = [&](model::Frame frame) {
    pictures.add_frame(frame);
    folder.add_frame(std::move(frame));
  };
  callbacks.keep_going = [](const model::HistoryRow&) { return !InterruptWatch::requested(); };
  callbacks.wants_checkpoint = [&] { return writer.is_due(); };
  callbacks.on_checkpoint = [&](const std::string& solver) {
    writer.write({start.case_text, folder.record(), solver}, [&folder, draw = pictures.take_drawing()] {
      folder.wait_for_frames();
      draw();
    });
  };
  std::string checkpoint = start.checkpoint ? std::exchange(start.checkpoint->solver, {}) : "";
  model::RunOutcome outcome = solve::simulate(start.loaded.model, settings, callbacks, std::move(checkpoint));
  progress.finish();
  writer.wait();
  folder.finish(outcome);
  pictures.finish(folder.history());
  return outcome;
}

results::RunFolder open_folder(const RunStart& start) {
  if (start.checkpoint) return {start.folder, start.checkpoint->record, start.loaded.model};
  return {start.folder, start.case_text, start.loaded.model};
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
    fmt::print(stderr, "knitmech: interrupted at {} strain; {}; to go on: knitmech run --resume {}\n",
               percent_text(outcome.strain), kept, folder.string());
  } else {
    fmt::print(stderr, "knitmech: error: {} {} {}\n", outcome.reason, outcome.advice, "W" + kept.substr(1) + ".");
  }
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  RunStart start = options.resume.empty() ? new_run(options.case_file, options.folder) : earlier_run(options.resume);
  const model::Model& model = start.loaded.model;
  const solve::SimulationSettings settings = resolved_settings(start.loaded, options.threads);
  const fs::path& folder = start.folder;
  const bool talks = !options.quiet && !options.json;

  if (talks) {
    const model::FabricFacts facts = model::describe(start.loaded.input, model);
    fmt::print("{}", run_head_text(start.loaded, facts, *settings.mass_scaling, *settings.threads, folder,
                                   start.resumed_at()));
    std::fflush(stdout);
  }
  results::RunFolder results = open_folder(start);
  RunPictures pictures(results, model, options.pictures);
  Progress progress(model.test, start.resumed_at().value_or(0), talks);
  const model::RunOutcome outcome = simulate_into(results, pictures, progress, start, settings);

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
