#include "run/run_case.h"

#include <string>
#include <utility>

#include "results/checkpoint_writer.h"
#include "results/run_folder.h"
#include "run/run_pictures.h"
#include "solve/mass_scaling.h"
#include "solve/threads.h"

namespace knitmech::run {
namespace {

results::RunFolder open_folder(const RunStart& start) {
  if (start.checkpoint) return {start.folder, start.checkpoint->record, start.loaded.model};
  return {start.folder, start.case_text, start.loaded.model, start.loaded.input.fabric.yarn_file.get()};
}

/// The simulation of a case with everything that listens to it.
model::RunOutcome simulate_into(results::RunFolder& folder, RunPictures& pictures, RunStart& start,
                                const solve::SimulationSettings& settings, const RunListener& listener) {
  results::CheckpointWriter writer(folder.path(), start.loaded.input.output.checkpoint_every);
  solve::SimulationCallbacks callbacks;
  callbacks.on_history = [&](const model::HistoryRow& row) {
    folder.add_history(row);
    if (listener.on_history) listener.on_history(row);
  };
  callbacks.on_frame = [&](model::Frame frame) {
    if (listener.on_frame) listener.on_frame(frame);
    pictures.add_frame(frame);
    folder.add_frame(std::move(frame));
  };
  callbacks.keep_going = [&](const model::HistoryRow&) { return !listener.keep_going || listener.keep_going(); };
  callbacks.wants_view = listener.wants_view;
  callbacks.on_view = listener.on_view;
  callbacks.wants_checkpoint = [&] { return writer.is_due(); };
  callbacks.on_checkpoint = [&](const std::string& solver) {
    writer.write({start.case_text, folder.record(), solver}, [&folder, draw = pictures.take_drawing()] {
      folder.wait_for_frames();
      draw();
    });
  };
  std::string checkpoint = start.checkpoint ? std::exchange(start.checkpoint->solver, {}) : "";
  model::RunOutcome outcome = solve::simulate(start.loaded.model, settings, callbacks, std::move(checkpoint));
  writer.wait();
  folder.finish(outcome);
  return outcome;
}

}  // namespace

solve::SimulationSettings resolved_settings(const LoadedCase& loaded, std::optional<int> threads) {
  solve::SimulationSettings settings = solve::settings_from(loaded.input);
  if (!settings.mass_scaling) settings.mass_scaling = solve::automatic_mass_scaling(loaded.model);
  settings.threads = threads ? *threads : solve::automatic_threads(loaded.model);
  return settings;
}

RunResult run_case(RunStart& start, const RunSettings& settings, const RunListener& listener) {
  results::RunFolder folder = open_folder(start);
  RunPictures pictures(folder, start.loaded.model, settings.pictures);
  const model::RunOutcome outcome = simulate_into(folder, pictures, start, settings.simulation, listener);
  pictures.finish(folder.history());
  const double diameter = start.loaded.model.sections.front().diameter;
  return {outcome, folder.history(), results::assess_quality(folder.history(), outcome, diameter)};
}

}  // namespace knitmech::run
