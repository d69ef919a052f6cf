#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/frame.h"
#include "model/model.h"
#include "model/run_outcome.h"
#include "results/contact_summary.h"
#include "results/frame_measures.h"
#include "results/quality.h"
#include "results/section_peaks.h"

namespace knitmech::results {

/// Raised when summary.json changes in a way that an older reader would misunderstand.
inline constexpr int kSummarySchema = 1;

/// The entry "format" of every summary.
inline constexpr const char* kSummaryFormat = "knitmech-run";

/// The content of summary.json while a run is under way: what is known of the model, status "running". It also marks
/// the folder as a run folder.
[[nodiscard]] std::string running_summary(const model::Model& model);

/// The content of summary.json of a finished run (docs/results.md); contacts are those of the last frame, empty if
/// there is none, peaks those of all frames; at the strains of the frames the curve is measured. Numbers that are not
/// finite or do not exist are null. Text that is not valid UTF-8 is written with replacement characters.
[[nodiscard]] std::string finished_summary(const model::Model& model, const std::vector<model::HistoryRow>& history,
                                           const std::vector<FrameMeasures>& frames,
                                           const std::optional<ContactSummary>& contacts, const SectionPeaks& peaks,
                                           const model::RunOutcome& outcome, const Quality& quality);

/// In the run folder.
inline constexpr const char* kSummaryFile = "summary.json";

/// Whether a file is the summary.json of a KnitMech run; false also if it does not exist or is no JSON.
[[nodiscard]] bool is_summary(const std::filesystem::path& path);

/// What the summary.json of a run says of it.
struct SummaryFacts {
  std::string title;
  std::string status;       ///< "running", "completed", "interrupted", "failed"
  double gauge_length = 0;  ///< [mm]
};

/// Throws FileError if the file cannot be read, and InputError if it lacks one of the facts.
[[nodiscard]] SummaryFacts facts_in_summary(const std::filesystem::path& path);

/// The status in the summary.json of a run.
[[nodiscard]] std::string status_in_summary(const std::filesystem::path& path);

/// Why the run of a summary.json has failed; empty if it has not.
[[nodiscard]] std::string reason_in_summary(const std::filesystem::path& path);

}  // namespace knitmech::results
