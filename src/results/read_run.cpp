#include "results/read_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/errors.h"
#include "model/build_model.h"
#include "model/case_file.h"
#include "results/history_file.h"
#include "results/run_folder.h"
#include "results/summary.h"

namespace knitmech::results {
namespace {

namespace fs = std::filesystem;

void check_is_run_folder(const fs::path& dir) {
  if (!fs::exists(dir)) throw InputError(fmt::format("There is no folder {}.", dir.string()));
  if (!fs::is_directory(dir)) {
    throw InputError(fmt::format("{} is a file; give the folder of a run.", dir.string()));
  }
  if (!fs::exists(dir / kSummaryFile)) {
    throw InputError(fmt::format("{} is not the folder of a run: it has no {}.", dir.string(), kSummaryFile));
  }
}

void check_has_frames(const StoredRun& run) {
  if (!run.frames.empty()) return;
  const char* const advice = run.summary.status == "running" ? "it is under way, or was killed before its first frame"
                                                             : "it ended before its first frame";
  throw InputError(fmt::format("The run in {} has stored no frame: {}.", run.dir.string(), advice));
}

model::Model model_of(const model::Case& input, const fs::path& file) {
  try {
    return model::build_model(input);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void check_is_same_model(const StoredRun& run) {
  if (run.model.n_nodes() == run.summary.model.nodes &&
      static_cast<int>(run.model.yarns.size()) == run.summary.model.yarns) {
    return;
  }
  throw InputError(fmt::format(
      "{} makes a model of {} nodes, but the run had {}: the case was changed since, or the run is of "
      "another version of KnitMech ({}).",
      (run.dir / kCaseFile).string(), run.model.n_nodes(), run.summary.model.nodes, run.summary.program_version));
}

}  // namespace

StoredRun read_run(const fs::path& dir) {
  check_is_run_folder(dir);
  StoredRun run;
  run.dir = dir;
  run.summary = read_summary(dir / kSummaryFile);
  run.frames = read_frames_collection(dir / kFramesFolder / kFramesCollection);
  check_has_frames(run);
  run.history = read_history(dir / kHistoryFile);
  run.input = model::read_case_file(dir / kCaseFile);
  run.model = model_of(run.input, dir / kCaseFile);
  check_is_same_model(run);
  return run;
}

const FrameEntry& nearest_frame(const StoredRun& run, double strain) {
  return *std::min_element(run.frames.begin(), run.frames.end(), [strain](const FrameEntry& a, const FrameEntry& b) {
    return std::abs(a.strain - strain) < std::abs(b.strain - strain);
  });
}

}  // namespace knitmech::results
