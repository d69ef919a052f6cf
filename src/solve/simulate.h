#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/case.h"
#include "model/frame.h"
#include "model/model.h"
#include "model/run_outcome.h"

namespace knitmech::solve {

/// How a model is stepped through time and what is reported on the way.
struct SimulationSettings {
  std::optional<double> mass_scaling;  ///< factor on every mass [-]; empty: see automatic_mass_scaling()
  double bulk_viscosity = 0.06;        ///< linear, on the axial strain rate [-]
  double mass_damping = 0;             ///< [1/s]
  double step_factor = 0.9;            ///< share of the stable step that is used [-]
  std::vector<double> frames_at;  ///< strains [-] at which a frame is reported, ascending; start and end always are
  int history_points = 1000;      ///< history rows over the test, besides the one at the start
  bool adapts_pace = false;       ///< of the driven grip, see Pace; never where masses are not scaled
  std::optional<int> threads;     ///< empty: see automatic_threads(). The results are the same to the last bit
  bool selective_mass = false;    ///< see selective_length()
};

[[nodiscard]] SimulationSettings settings_from(const model::Case& input);

/// What the caller wants to hear while a simulation runs. Any of them may be empty.
struct SimulationCallbacks {
  std::function<void(const model::HistoryRow&)>
      on_history;  ///< settings.history_points times, evenly over strain, and with each frame
  std::function<void(model::Frame)> on_frame;  ///< at the start, at settings.frames_at, at the end
  /// Asked every few dozen steps; false interrupts. It may block, and the run pauses; that time does not count as time
  /// in the solver.
  std::function<bool(const model::HistoryRow& latest)> keep_going;
  std::function<bool()> wants_checkpoint = {};  ///< asked as often as keep_going
  /// With all that the run remembers, where one is wanted and when the run is interrupted.
  std::function<void(const std::string&)> on_checkpoint = {};
  std::function<bool()> wants_view = {};  ///< asked as often as keep_going, and before it
  /// Where one is wanted, the present state for someone who watches: a frame with index -1 that counts as none, and
  /// whose forces are those of the last step. Of its history row only time, displacement and strain are of the present;
  /// the rest is of the latest row. Whether anyone watches changes no number of the run.
  std::function<void(model::Frame)> on_view = {};
};

/// Runs the tensile test of a model by explicit dynamics (docs/theory.md).
///
/// Never throws for a simulation that goes wrong: that is an outcome with status failed, reason and advice. Whatever
/// ends the run, a last history row and a last frame are reported first.
/// \param checkpoint of an earlier run of the same model with the same settings, which goes on from there as if it had
/// never ended: what it reported before the checkpoint is not reported again, what it reported after it is, and every
/// number is the same to the last bit, provided that the program and the kind of processor are. Empty: from the start
/// @throws InputError if the checkpoint is not one of this program
model::RunOutcome simulate(const model::Model& model, const SimulationSettings& settings,
                           const SimulationCallbacks& callbacks, std::string checkpoint = {});

}  // namespace knitmech::solve
