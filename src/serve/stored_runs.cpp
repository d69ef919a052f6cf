#include "serve/stored_runs.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "base/errors.h"
#include "base/text.h"
#include "model/bending_measure.h"
#include "model/case_file.h"
#include "report/run_report.h"
#include "results/checkpoint_file.h"
#include "results/curve_stages.h"
#include "results/folder_lock.h"
#include "results/history_file.h"
#include "results/run_folder.h"
#include "results/summary.h"
#include "serve/constants.h"
#include "serve/refusal.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;

constexpr double kNanoseconds = 1e9;  // in a second

/// Time of the last change [ns since 1970] and size of a file; zeros if there is none.
std::array<std::int64_t, 2> stamp_of_file(const fs::path& file) {
  struct stat facts = {};
  if (stat(file.c_str(), &facts) != 0) return {0, 0};
  const auto seconds = static_cast<std::int64_t>(facts.st_mtim.tv_sec);
  return {seconds * static_cast<std::int64_t>(kNanoseconds) + facts.st_mtim.tv_nsec,
          static_cast<std::int64_t>(facts.st_size)};
}

/// A damaged summary does not say whose it is; beside a history it is one of a run.
bool is_run_folder(const fs::path& folder) {
  const fs::path summary = folder / results::kSummaryFile;
  std::error_code ignored;
  if (!fs::is_regular_file(summary, ignored)) return false;
  try {
    return results::is_summary(summary) || fs::is_regular_file(folder / results::kHistoryFile, ignored);
  } catch (const FileError&) {
    return true;  // head() tells why it cannot be read
  }
}

/// Whether a folder is one of a folder's own, and not a link that leads out of it.
bool is_inside(const fs::path& folder, const fs::path& root) {
  std::error_code code;
  const fs::path real = fs::canonical(folder, code);
  if (code || !fs::is_directory(real, code)) return false;
  const fs::path real_root = fs::canonical(root, code);
  if (code) return false;
  const auto [end, ignored] = std::mismatch(real_root.begin(), real_root.end(), real.begin(), real.end());
  return end == real_root.end() && real != real_root;
}

std::string sentences(const results::RunSummary& summary) {
  if (summary.reason.empty() || summary.advice.empty()) return summary.reason + summary.advice;
  return summary.reason + " " + summary.advice;
}

/// What is known only by the history of a run as long as it is under way.
void set_progress(RunHead& head, const fs::path& folder) {
  const fs::path file = folder / results::kHistoryFile;
  if (!fs::exists(file)) return;
  const std::vector<model::HistoryRow> rows = results::read_history(file);
  head.rows = rows.size();
  if (!rows.empty()) head.strain = rows.back().strain;
  head.frames = frames_in(folder).size();
}

void read_head(RunHead& head, const fs::path& folder) {
  const results::RunSummary summary = results::read_summary(folder / results::kSummaryFile);
  head.title = summary.title;
  head.strain = summary.strain.value_or(0);
  head.rows = static_cast<std::size_t>(std::max(0L, summary.history_rows.value_or(0)));
  head.frames = static_cast<std::size_t>(std::max(0L, summary.n_frames.value_or(0)));
  head.seconds = summary.wall_seconds.value_or(0);
  head.message = sentences(summary);
  if (summary.status == "running") set_progress(head, folder);
  const fs::path file = folder / results::kCaseFile;
  if (summary.status != "running" || fs::exists(file)) head.target_strain = model::read_case_file(file).test.strain;
  head.status = summary.status;
  if (head.status == "running" && !results::may_be_written(folder)) {
    head.status = "interrupted";
    head.message = "The program that ran it ended before the run did.";
  }
  head.can_go_on = head.status == "interrupted" && fs::exists(folder / results::kCheckpointFile);
}

}  // namespace

bool is_run_name(const std::string& id) {
  constexpr std::size_t kLongest = 255;  // of a file [bytes]
  const auto is_unfit = [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '/' || c == '\\'; };
  return !id.empty() && id.size() <= kLongest && id.front() != '.' && id.find("..") == std::string::npos &&
         std::none_of(id.begin(), id.end(), is_unfit);
}

std::vector<results::FrameEntry> frames_in(const fs::path& folder) {
  const fs::path file = folder / results::kFramesFolder / results::kFramesCollection;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {};
  return results::read_frames_collection(file);
}

fs::path StoredRuns::folder_of(const std::string& id) const {
  fs::path folder = root_ / id;
  if (!is_run_name(id) || !is_inside(folder, root_) || !is_run_folder(folder)) {
    throw Refusal(404, fmt::format("there is no run {}", base::in_quotes(id)));
  }
  return folder;
}

StoredRuns::Stamp StoredRuns::stamp_of(const fs::path& folder) {
  Stamp stamp;
  for (const fs::path& file :
       {fs::path(results::kSummaryFile), fs::path(results::kCaseFile), fs::path(results::kHistoryFile),
        fs::path(results::kCheckpointFile), fs::path(results::kFramesFolder) / results::kFramesCollection}) {
    const auto of_file = stamp_of_file(folder / file);
    stamp.insert(stamp.end(), of_file.begin(), of_file.end());
  }
  stamp.push_back(results::may_be_written(folder) ? 1 : 0);
  return stamp;
}

RunHead StoredRuns::head_of(const std::string& id, const fs::path& folder) {
  Stamp stamp = stamp_of(folder);
  if (const auto known = known_heads_.find(id); known != known_heads_.end() && known->second.stamp == stamp) {
    return known->second.head;
  }
  RunHead head;
  head.id = id;
  head.modified = static_cast<double>(stamp.front()) / kNanoseconds;
  try {
    read_head(head, folder);
  } catch (const std::exception& error) {
    head.status = "damaged";
    head.message = error.what();
  }
  if (head.title.empty()) head.title = id;
  known_heads_[id] = {std::move(stamp), head};
  return head;
}

RunHead StoredRuns::head(const std::string& id) {
  const fs::path folder = folder_of(id);
  const std::lock_guard lock(heads_mutex_);
  return head_of(id, folder);
}

std::map<std::string, RunHead> StoredRuns::heads() {
  const std::lock_guard lock(heads_mutex_);
  std::map<std::string, RunHead> heads;
  std::error_code code;
  for (fs::directory_iterator entry(root_, code), end; !code && entry != end; entry.increment(code)) {
    const std::string id = entry->path().filename().string();
    if (!is_run_name(id) || !is_inside(entry->path(), root_)) continue;
    const auto known = known_heads_.find(id);
    const bool is_as_known = known != known_heads_.end() && known->second.stamp == stamp_of(entry->path());
    if (is_as_known || is_run_folder(entry->path())) heads[id] = head_of(id, entry->path());
  }
  std::erase_if(known_heads_, [&](const auto& known) { return !heads.contains(known.first); });
  return heads;
}

std::vector<model::HistoryRow> StoredRuns::history(const std::string& id, std::size_t from) const {
  std::vector<model::HistoryRow> rows = results::read_history(folder_of(id) / results::kHistoryFile);
  rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(std::min(from, rows.size())));
  return rows;
}

std::shared_ptr<const results::StoredRun> StoredRuns::read(const std::string& id) {
  const fs::path folder = folder_of(id);
  const Stamp stamp = stamp_of(folder);
  const std::lock_guard lock(runs_mutex_);
  const auto known = std::find_if(known_runs_.begin(), known_runs_.end(),
                                  [&](const KnownRun& one) { return one.id == id && one.stamp == stamp; });
  if (known != known_runs_.end()) {
    known_runs_.splice(known_runs_.begin(), known_runs_, known);
    return known_runs_.front().run;
  }
  known_runs_.remove_if([&](const KnownRun& one) { return one.id == id; });
  if (known_runs_.size() >= kRunsInMemory) known_runs_.pop_back();
  known_runs_.push_front({id, stamp, std::make_shared<const results::StoredRun>(results::read_run(folder))});
  return known_runs_.front().run;
}

RunDetail StoredRuns::detail(const std::string& id) {
  const fs::path folder = folder_of(id);
  RunDetail detail;
  detail.head = head(id);
  detail.report = fs::exists(folder / report::kReportFile);
  if (detail.head.status == "damaged") return detail;
  const results::RunSummary summary = results::read_summary(folder / results::kSummaryFile);
  detail.case_text = model::case_file_text(folder / results::kCaseFile);
  detail.frames = frames_in(folder);
  detail.gauge_length = summary.model.gauge_length.value_or(0);
  detail.nodes = summary.model.nodes;
  detail.elements = summary.model.elements;
  detail.mass_scaling = summary.mass_scaling;
  detail.threads = summary.threads;
  const std::vector<model::HistoryRow> rows = history(id, 0);
  if (!rows.empty()) detail.width = rows.front().width;
  if (summary.status != "running" && !detail.frames.empty()) {
    detail.stages = results::curve_stages(rows, model::bending_measure(read(id)->model)).stages;
  }
  if (summary.quality) detail.summary = summary;
  return detail;
}

}  // namespace knitmech::serve
