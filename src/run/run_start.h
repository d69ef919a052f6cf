#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "results/checkpoint_file.h"
#include "run/load_case.h"

namespace knitmech::run {

/// What a run begins with.
struct RunStart {
  LoadedCase loaded;
  std::string case_text;  ///< the whole case, as it stands in the run folder
  std::filesystem::path folder;
  std::optional<results::Checkpoint> checkpoint;  ///< of the run that it goes on with; empty for a new one

  /// Strain of the last history row before the checkpoint [-].
  [[nodiscard]] std::optional<double> resumed_at() const;
};

/// Where results go by default: results/jersey for some/where/jersey.toml; results/where for some/where/case.toml or
/// some/where/study.toml.
[[nodiscard]] std::filesystem::path default_folder(const std::filesystem::path& file);

/// A new run. \param folder for the results; empty: results/ and the name of the case
[[nodiscard]] RunStart new_run(const std::filesystem::path& case_file, const std::filesystem::path& folder);

/// A new run of a case that is loaded.
[[nodiscard]] RunStart new_run(LoadedCase loaded, const std::filesystem::path& folder);

/// A new run of a case that stands in no file. @throws InputError for a geometry that cannot be
[[nodiscard]] RunStart run_of(const model::Case& input, const std::filesystem::path& folder);

/// The run in a folder, from its last checkpoint on. Its case.toml must still be the case that the run began with, but
/// for output.checkpoint_every.
/// @throws InputError if the run cannot go on, see results::read_checkpoint(), or if the case is another one
[[nodiscard]] RunStart earlier_run(const std::filesystem::path& folder);

}  // namespace knitmech::run
