#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "curves/yarn_file.h"
#include "model/frame.h"
#include "model/model.h"
#include "model/run_outcome.h"
#include "results/folder_lock.h"
#include "results/history_file.h"
#include "results/run_record.h"
#include "results/write_queue.h"

namespace knitmech::results {

/// Names inside a run folder, beside kSummaryFile and kCheckpointFile; the lists of frames are in the folder of frames.
inline constexpr const char* kCaseFile = "case.toml";
inline constexpr const char* kLogFile = "log.txt";
inline constexpr const char* kFramesFolder = "frames";
inline constexpr const char* kFramesCollection = "frames.pvd";
inline constexpr const char* kContactsCollection = "contacts.pvd";

/// The folder of one run, written while the simulation goes on (docs/results.md):
///
///     case.toml summary.json history.csv log.txt checkpoint.bin
///     yarns.csv, yarns.bcc or yarns.yarns    of a fabric from a file of yarns
///     frames/frames.pvd    frames/frame_0000.vtp ...
///     frames/contacts.pvd  frames/contacts_0000.vtp ...  frames/contacts_0000.csv ...
///
/// A reader never sees a half file: every file is written under another name and renamed, except log.txt, which grows
/// by whole lines. summary.json says "running" until finish(). A killed run keeps its frames, but those that were still
/// pending, and all history but that of the last second (kHistoryRewriteInterval).
///
/// Frames are written on a thread of their own (WriteQueue). All members throw FileError with the path and the reason
/// if a file cannot be written; for a frame, the next member that is called does.
class RunFolder {
 public:
  /// Makes the folder, with its parents, or takes over the folder of an older run, from which the files listed above
  /// are removed and nothing else.
  ///
  /// Throws InputError, without touching anything, if dir is a file, a folder with something in it that is not a
  /// KnitMech run folder (recognised by its summary.json), or that of a run under way (FolderLock).
  /// \param model must outlive the run folder and stay as it is: large models are not copied
  /// \param yarns the file that case_toml names beside it; null if it names none
  RunFolder(std::filesystem::path dir, const std::string& case_toml, const model::Model& model,
            const curves::YarnFile* yarns = nullptr);
  RunFolder(std::filesystem::path dir, const std::string& case_toml, model::Model&& model) = delete;

  /// Takes up the run in a folder where it had left this record: what it wrote after that is removed, or will be
  /// written anew.
  RunFolder(std::filesystem::path dir, RunRecord record, const model::Model& model);
  RunFolder(std::filesystem::path dir, RunRecord record, model::Model&& model) = delete;

  /// Keeps a row of the history; history.csv is rewritten at most once per kHistoryRewriteInterval.
  void add_history(const model::HistoryRow& row);

  /// Writes history.csv up to here, and beside the run the frame, its contacts and the lists of both. Waits only if
  /// kMostPendingWrites frames before are still being written.
  void add_frame(model::Frame frame);

  /// Waits until all frames that were added before are written; on any thread.
  void wait_for_frames() { queue_.finish(); }

  /// Appends a line to log.txt.
  void log(const std::string& line);

  /// Writes the whole history and the summary with the contacts of the last frame, the largest section results of all
  /// frames and the quality block (assess_quality()). Removes the checkpoint, unless the run was interrupted.
  void finish(const model::RunOutcome& outcome);

  [[nodiscard]] const std::filesystem::path& path() const { return dir_; }
  [[nodiscard]] const std::vector<model::HistoryRow>& history() const { return record_.history; }
  [[nodiscard]] const RunRecord& record() const { return record_; }

 private:
  void write_history();
  void write_frame_files(const model::Frame& frame);
  void write_collections(const std::vector<FrameEntry>& frames) const;

  std::filesystem::path dir_;
  std::optional<FolderLock> lock_;
  const model::Model& model_;
  RunRecord record_;
  std::string history_text_;
  std::chrono::steady_clock::time_point history_written_;
  WriteQueue queue_;  ///< last, so that its thread ends first
};

}  // namespace knitmech::results
