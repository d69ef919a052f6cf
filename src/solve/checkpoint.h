#pragma once

#include <cstddef>
#include <string>

#include "model/frame.h"
#include "model/run_outcome.h"
#include "solve/explicit_solver.h"

namespace knitmech::solve {

/// What a run knows besides its solver.
struct RunProgress {
  model::HistoryRow latest;     ///< reported
  model::RunOutcome outcome;    ///< so far; wall_seconds up to here
  int n_frames = 0;             ///< reported
  std::size_t next_report = 0;  ///< number of the strain that the run is on the way to

  template <class Archive>
  void serialize(Archive& archive) {
    archive(latest, outcome, n_frames, next_report);
  }
};

/// All that a run remembers, as bytes: every bit of it, little-endian whatever the processor. Taken between two steps.
///
/// Copies the memory of the solver, about 0.6 kB an element, and takes as long as 5 to 20 steps (bench/).
[[nodiscard]] std::string checkpoint_of(const ExplicitSolver& solver, const RunProgress& progress);

/// Puts a run back to where a checkpoint was taken; it goes on to the bitwise same result.
/// \param solver of the same model and settings
/// @throws InputError if the checkpoint is not one of this program
void go_back_to(std::string checkpoint, ExplicitSolver& solver, RunProgress& progress);

}  // namespace knitmech::solve
