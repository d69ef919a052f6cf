#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/frame.h"
#include "model/run_outcome.h"
#include "results/quality.h"
#include "run/run_start.h"
#include "solve/simulate.h"

namespace knitmech::run {

/// How a case is run, besides what the case says.
struct RunSettings {
  solve::SimulationSettings simulation;  ///< see resolved_settings()
  bool pictures = true;                  ///< of the frames and of the curve
};

/// Who listens to a run, and may end it. All are called on the thread of the run and may be empty.
struct RunListener {
  std::function<void(const model::HistoryRow&)> on_history{};
  std::function<void(const model::Frame&)> on_frame{};  ///< each that is stored
  /// False ends the run, which can be gone on with later. The run pauses as long as this blocks.
  std::function<bool()> keep_going{};
  std::function<bool()> wants_view{};           ///< see solve::SimulationCallbacks
  std::function<void(model::Frame)> on_view{};  ///< of the present state; none of the stored frames
};

/// How a run ended.
struct RunResult {
  model::RunOutcome outcome;
  std::vector<model::HistoryRow> history;
  results::Quality quality;
};

/// The settings of a case with all that the program chooses filled in. \param threads empty: as many as serve the
/// fabric
[[nodiscard]] solve::SimulationSettings resolved_settings(const LoadedCase& loaded, std::optional<int> threads);

/// Runs a case, or goes on with it, and leaves its run folder (results::RunFolder) with checkpoints on the way.
///
/// A simulation that cannot go on is a result with its reason. Several may run at once on threads of their own, each
/// with its own folder. What the solver remembers of an earlier run is taken out of start.
/// @throws InputError if the folder holds something else, FileError if it cannot be written
[[nodiscard]] RunResult run_case(RunStart& start, const RunSettings& settings, const RunListener& listener);

}  // namespace knitmech::run
