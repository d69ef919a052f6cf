#pragma once

#include <functional>
#include <optional>
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
  std::function<void(const model::Frame&)> on_frame;                ///< at the start, at settings.frames_at, at the end
  std::function<bool(const model::HistoryRow& latest)> keep_going;  ///< asked every few dozen steps; false interrupts
};

/// Runs the tensile test of a model by explicit dynamics (docs/theory.md).
///
/// Never throws for a simulation that goes wrong: that is an outcome with status failed, reason and advice. Whatever
/// ends the run, a last history row and a last frame are reported first.
model::RunOutcome simulate(const model::Model& model, const SimulationSettings& settings,
                           const SimulationCallbacks& callbacks);

}  // namespace knitmech::solve
