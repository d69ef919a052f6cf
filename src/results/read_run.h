#pragma once

#include <filesystem>
#include <vector>

#include "model/case.h"
#include "model/frame.h"
#include "model/model.h"
#include "results/collection_file.h"
#include "results/run_summary.h"

namespace knitmech::results {

/// A frame that is stored: its index and its strain [-], as frames.pvd has them.
using StoredFrame = FrameEntry;

/// A run folder (run_folder.h) that is read back. Frames are large and stay on the disk: read_frame().
struct StoredRun {
  std::filesystem::path dir;
  model::Case input;
  model::Model model;                      ///< built anew from the case
  std::vector<model::HistoryRow> history;  ///< may be empty
  RunSummary summary;
  std::vector<StoredFrame> frames;  ///< those in frames.pvd, in the order of time; at least one
};

/// Reads the folder of a run, whether the run has ended or not.
///
/// Throws InputError with one sentence if the folder is not there or not of a run, if no frame was stored in it (yet),
/// if one of its files is damaged, or if the case no longer makes the model that was run; FileError if a file is
/// missing or cannot be read.
[[nodiscard]] StoredRun read_run(const std::filesystem::path& dir);

/// The frame of a run whose strain is nearest to one that is given [-]; the first of equals.
[[nodiscard]] const StoredFrame& nearest_frame(const StoredRun& run, double strain);

}  // namespace knitmech::results
