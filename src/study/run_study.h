#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/frame.h"
#include "study/measures.h"
#include "study/study.h"

namespace knitmech::study {

/// Where a variant of a study stands.
enum class Standing {
  pending,  ///< not begun, or interrupted: the next time it begins, or goes on
  running,
  completed,
  failed,     ///< the simulation could not go on
  impossible  ///< there is no such fabric
};

/// "completed", "failed", ...
[[nodiscard]] const char* name_of(Standing standing);

/// A variant, and how it fared.
struct VariantState {
  Variant variant;
  Standing standing = Standing::pending;
  std::string reason;             ///< of a variant that is failed or impossible: why
  std::filesystem::path folder;   ///< its run folder
  std::vector<Measure> measures;  ///< of a run that is completed or has failed, see measures_of()
  bool was_done = false;          ///< an earlier study had run it
};

/// Who listens to a study, and may end it. They are called by one thread at a time and may be empty.
struct StudyListener {
  std::function<void(const VariantState&)> on_change{};  ///< a variant has begun or ended
  std::function<void(const VariantState&, const model::HistoryRow&)> on_history{};
  std::function<bool()> keep_going{};  ///< false ends the study; called by all threads at once
};

/// How a study is run.
struct StudySettings {
  std::filesystem::path folder;
  int jobs = 1;                ///< runs at the same time
  std::optional<int> threads;  ///< of each run; empty: what the processor has for each
};

/// Runs all variants of a study, the largest first, each into the folder runs/<its name>, and returns them in the order
/// of the plan.
///
/// A variant that an earlier study of the same folder has run with the same case is not run again, one that was
/// interrupted goes on from its checkpoint. What goes wrong with one variant is kept as its reason and does not stop
/// the others. The tables of the folder (write_tables()) are brought up to date whenever a variant has ended.
/// @throws InputError if the folder holds something else than a study, FileError if it cannot be written
[[nodiscard]] std::vector<VariantState> run_study(const Study& study, const StudySettings& settings,
                                                  const StudyListener& listener);

}  // namespace knitmech::study
