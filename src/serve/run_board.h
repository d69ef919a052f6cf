#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "serve/run_json.h"
#include "serve/runs.h"

namespace knitmech::serve {

/// Knows what has changed since somebody has looked: every change has a number.
class RunBoard {
 public:
  /// Notes the runs that there are now.
  void set(const std::map<std::string, RunHead>& heads);

  /// What has changed after the change with the number `seen`, at most one event per run, in the order of the changes.
  /// Sets `seen` to the number of the last one. 0: all runs.
  [[nodiscard]] std::vector<RunEvent> since(std::uint64_t& seen) const;

 private:
  struct Entry {
    std::uint64_t changed = 0;
    std::string json;  ///< of the head; empty: the run is gone
  };
  mutable std::mutex mutex_;
  std::uint64_t n_changes_ = 1;  ///< the first is that there is a board
  std::map<std::string, Entry> entries_;
};

}  // namespace knitmech::serve
