#pragma once

#include <filesystem>
#include <string>

#include "results/run_record.h"

namespace knitmech::results {

/// In the run folder; there as long as a run can go on from it.
inline constexpr const char* kCheckpointFile = "checkpoint.bin";

/// A run at one instant: all that it takes to go on from there.
struct Checkpoint {
  std::string case_text;  ///< the whole case, as in case.toml
  RunRecord record;       ///< what was written until then
  std::string solver;     ///< what the simulation remembers, see solve::simulate()
};

/// Writes the checkpoint into a run folder in place of the one before. @throws FileError
void write_checkpoint(const std::filesystem::path& dir, const Checkpoint& checkpoint);

/// The checkpoint of a run that has not ended.
///
/// @throws InputError if dir is no run folder, if its run has ended, if it has no checkpoint, if that is damaged or was
/// written by another version of the program; the message says which, and what to do
/// @throws FileError if it cannot be read
[[nodiscard]] Checkpoint read_checkpoint(const std::filesystem::path& dir);

}  // namespace knitmech::results
