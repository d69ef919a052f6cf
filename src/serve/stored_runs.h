#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "results/read_run.h"
#include "serve/run_json.h"

namespace knitmech::serve {

/// The runs that are stored in a folder, each in a folder of its own, whoever ran them. All members may be called from
/// any thread, and see what other programs do there.
class StoredRuns {
 public:
  /// \param root the folder; need not be there
  explicit StoredRuns(std::filesystem::path root) : root_(std::move(root)) {}

  /// The heads of all of them by their ids. A run whose files cannot be read has the status "damaged" and the reason.
  [[nodiscard]] std::map<std::string, RunHead> heads();

  /// The folder of a run. Throws Refusal with 404 if the id is not the name of a folder in the folder of runs, if it
  /// leads out of that by a link, or if there is no run in it.
  [[nodiscard]] std::filesystem::path folder_of(const std::string& id) const;

  [[nodiscard]] RunHead head(const std::string& id);
  [[nodiscard]] RunDetail detail(const std::string& id);
  [[nodiscard]] std::vector<model::HistoryRow> history(const std::string& id, std::size_t from) const;

  /// A run that is read back; the latest are kept in memory as long as their files stay as they are. Throws like
  /// results::read_run().
  [[nodiscard]] std::shared_ptr<const results::StoredRun> read(const std::string& id);

 private:
  /// Time and size of the files that tell whether a run has changed.
  using Stamp = std::vector<std::int64_t>;
  struct KnownHead {
    Stamp stamp;
    RunHead head;
  };
  struct KnownRun {
    std::string id;
    Stamp stamp;
    std::shared_ptr<const results::StoredRun> run;
  };

  [[nodiscard]] static Stamp stamp_of(const std::filesystem::path& folder);
  [[nodiscard]] RunHead head_of(const std::string& id, const std::filesystem::path& folder);

  std::filesystem::path root_;
  std::mutex heads_mutex_, runs_mutex_;
  std::map<std::string, KnownHead> known_heads_;
  std::list<KnownRun> known_runs_;  ///< the latest first
};

/// The frames that are stored in the folder of a run; none if it has no list of them yet.
[[nodiscard]] std::vector<results::FrameEntry> frames_in(const std::filesystem::path& folder);

/// Whether an id can be the name of a run folder: one name, not hidden, without control characters.
[[nodiscard]] bool is_run_name(const std::string& id);

}  // namespace knitmech::serve
