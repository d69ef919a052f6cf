#include "results/run_folder.h"

#include <fmt/core.h>

#include <cerrno>
#include <fstream>
#include <memory>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/errors.h"
#include "results/atomic_file.h"
#include "results/checkpoint_file.h"
#include "results/constants.h"
#include "results/contact_file.h"
#include "results/frame_file.h"
#include "results/history_file.h"
#include "results/quality.h"
#include "results/summary.h"

namespace knitmech::results {
namespace {

namespace fs = std::filesystem;

[[nodiscard]] FileError folder_error(const fs::path& dir, const std::error_code& code) {
  return FileError{fmt::format("Cannot write the run folder \"{}\": {}.", dir.string(), code.message())};
}

bool is_empty_folder(const fs::path& dir) {
  std::error_code code;
  const bool empty = fs::is_empty(dir, code);
  if (code) {
    throw folder_error(dir, code);
  }
  return empty;
}

void refuse_foreign_folder(const fs::path& dir) {
  if (!fs::exists(dir)) {
    return;
  }
  if (!fs::is_directory(dir)) {
    throw InputError(fmt::format("\"{}\" is a file; give a folder for the results.", dir.string()));
  }
  if (!is_empty_folder(dir) && !is_summary(dir / kSummaryFile)) {
    throw InputError(fmt::format(
        "\"{}\" holds files that are not a KnitMech run; give a new or empty folder for the results.", dir.string()));
  }
}

/// start0012end
bool is_numbered(std::string_view name, std::string_view start, std::string_view end) {
  if (!name.starts_with(start) || !name.ends_with(end) || name.size() < start.size() + 4 + end.size()) {
    return false;
  }
  name.remove_prefix(start.size());
  name.remove_suffix(end.size());
  return name.find_first_not_of("0123456789") == std::string_view::npos;
}

/// frame_0012.vtp, contacts_0012.vtp, contacts_0012.csv, also under their temporary names.
bool is_frame_file(std::string_view name) {
  if (name.ends_with(kPartialSuffix)) {
    name.remove_suffix(kPartialSuffix.size());
  }
  return is_numbered(name, "frame_", ".vtp") || is_numbered(name, "contacts_", ".vtp") ||
         is_numbered(name, "contacts_", ".csv");
}

/// Removes a file of ours and what is left of an interrupted write of it.
void remove_own(const fs::path& path) {
  fs::path partial = path;
  partial += kPartialSuffix;
  fs::remove(path);
  fs::remove(partial);
}

/// Removes the files of all frames but some.
void remove_frames(const fs::path& frames, const std::set<std::string>& kept) {
  if (!fs::is_directory(frames)) {
    return;
  }
  std::vector<fs::path> old_frames;
  for (const fs::directory_entry& entry : fs::directory_iterator(frames)) {
    const std::string name = entry.path().filename().string();
    if (is_frame_file(name) && !kept.contains(name)) {
      old_frames.push_back(entry.path());
    }
  }
  for (const fs::path& file : old_frames) {
    fs::remove(file);
  }
}

void remove_older_run(const fs::path& dir) {
  for (const char* name : {kHistoryFile, kLogFile, kCaseFile}) {
    remove_own(dir / name);
  }
  for (const std::string_view ending : curves::kYarnFileEndings) {
    remove_own(dir / curves::plain_name(ending));
  }
  const fs::path frames = dir / kFramesFolder;
  remove_frames(frames, {});
  remove_own(frames / kFramesCollection);
  remove_own(frames / kContactsCollection);
}

std::set<std::string> files_of(const std::vector<FrameEntry>& frames) {
  std::set<std::string> files;
  for (const FrameEntry& frame : frames) {
    files.insert(
        {frame_file_name(frame.index), contact_table_file_name(frame.index), contact_points_file_name(frame.index)});
  }
  return files;
}

/// Writes what a function gives to a sink.
template <typename Write>
void write_pieces(const fs::path& path, const Write& write, const model::Model& model, const model::Frame& frame) {
  AtomicFile file(path);
  write(model, frame, [&file](std::string_view piece) { file.write(piece); });
  file.finish();
}

}  // namespace

RunFolder::RunFolder(fs::path dir, const std::string& case_toml, const model::Model& model,
                     const curves::YarnFile* yarns)
    : dir_(std::move(dir)), model_(model), history_text_(std::string{kHistoryHeader} + "\n") {
  try {
    refuse_foreign_folder(dir_);
    fs::create_directories(dir_);
    lock_.emplace(dir_);
    // A checkpoint of the older run must not outlive what it belongs to.
    remove_own(dir_ / kCheckpointFile);
    // The summary goes first: it marks the folder as ours even if the program is killed before the next file.
    write_file_atomically(dir_ / kSummaryFile, running_summary(model_));
    remove_older_run(dir_);
    fs::create_directories(dir_ / kFramesFolder);
  } catch (const fs::filesystem_error& error) {
    throw folder_error(dir_, error.code());
  }
  if (yarns != nullptr) write_file_atomically(dir_ / curves::plain_name(yarns->ending), yarns->bytes);
  write_file_atomically(dir_ / kCaseFile, case_toml);
  write_collections(record_.frames);
  write_history();
}

RunFolder::RunFolder(fs::path dir, RunRecord record, const model::Model& model)
    : dir_(std::move(dir)),
      model_(model),
      record_(std::move(record)),
      history_text_(std::string{kHistoryHeader} + "\n") {
  lock_.emplace(dir_);
  for (const model::HistoryRow& row : record_.history) history_text_ += history_line(row);
  write_file_atomically(dir_ / kSummaryFile, running_summary(model_));
  try {
    remove_frames(dir_ / kFramesFolder, files_of(record_.frames));
  } catch (const fs::filesystem_error& error) {
    throw folder_error(dir_, error.code());
  }
  write_collections(record_.frames);
  write_history();
}

void RunFolder::add_history(const model::HistoryRow& row) {
  queue_.check();
  record_.history.push_back(row);
  history_text_ += history_line(row);
  const std::chrono::duration<double> age = std::chrono::steady_clock::now() - history_written_;
  if (age.count() >= kHistoryRewriteInterval) {
    write_history();
  }
}

void RunFolder::add_frame(model::Frame frame) {
  record_.frames.push_back({frame.index, frame.history.strain});
  record_.measures.push_back(measure_frame(frame));
  record_.contacts = summarise_contacts(model_, frame.contacts);
  update(record_.peaks, frame);
  write_history();
  // A job must be copyable, which a frame of a large fabric had better not be.
  const auto kept = std::make_shared<const model::Frame>(std::move(frame));
  queue_.add([this, kept, written = record_.frames] {
    write_frame_files(*kept);
    write_collections(written);
  });
}

void RunFolder::write_frame_files(const model::Frame& frame) {
  const fs::path folder = dir_ / kFramesFolder;
  write_pieces(folder / frame_file_name(frame.index), write_frame, model_, frame);
  write_pieces(folder / contact_table_file_name(frame.index), write_contact_table, model_, frame);
  write_pieces(folder / contact_points_file_name(frame.index), write_contact_points, model_, frame);
}

void RunFolder::log(const std::string& line) {
  const fs::path path = dir_ / kLogFile;
  errno = 0;
  std::ofstream file(path, std::ios::app | std::ios::binary);
  file << line + "\n";
  file.close();
  if (!file) {
    const std::error_code code(errno != 0 ? errno : EIO, std::generic_category());
    throw FileError(fmt::format("Cannot write \"{}\": {}.", path.string(), code.message()));
  }
}

void RunFolder::finish(const model::RunOutcome& outcome) {
  write_history();
  queue_.finish();
  const double diameter = model_.sections.empty() ? 0.0 : model_.sections.front().diameter;
  const Quality quality = assess_quality(record_.history, outcome, diameter);
  write_file_atomically(dir_ / kSummaryFile, finished_summary(model_, record_.history, record_.measures,
                                                              record_.contacts, record_.peaks, outcome, quality));
  if (outcome.status != model::RunStatus::interrupted) remove_own(dir_ / kCheckpointFile);
}

void RunFolder::write_collections(const std::vector<FrameEntry>& frames) const {
  const fs::path folder = dir_ / kFramesFolder;
  write_file_atomically(folder / kFramesCollection, collection_text(frames, frame_file_name));
  write_file_atomically(folder / kContactsCollection, collection_text(frames, contact_points_file_name));
}

void RunFolder::write_history() {
  write_file_atomically(dir_ / kHistoryFile, history_text_);
  history_written_ = std::chrono::steady_clock::now();
}

}  // namespace knitmech::results
