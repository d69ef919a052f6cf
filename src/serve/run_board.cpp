#include "serve/run_board.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace knitmech::serve {
namespace {

std::string gone_json(const std::string& id) {
  const nlohmann::json document = {{"id", id}};
  return document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void RunBoard::set(const std::map<std::string, RunHead>& heads) {
  const std::lock_guard lock(mutex_);
  for (auto& [id, entry] : entries_) {
    if (heads.contains(id) || entry.json.empty()) continue;
    entry = {++n_changes_, ""};
  }
  for (const auto& [id, head] : heads) {
    std::string json = head_json(head);
    Entry& entry = entries_[id];
    if (entry.json != json) entry = {++n_changes_, std::move(json)};
  }
}

std::vector<RunEvent> RunBoard::since(std::uint64_t& seen) const {
  const std::lock_guard lock(mutex_);
  std::vector<std::pair<std::uint64_t, RunEvent>> changes;
  for (const auto& [id, entry] : entries_) {
    const bool is_gone = entry.json.empty();
    if (entry.changed <= seen || (seen == 0 && is_gone)) continue;
    changes.emplace_back(entry.changed, is_gone ? RunEvent{"gone", gone_json(id)} : RunEvent{"run", entry.json});
  }
  std::sort(changes.begin(), changes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<RunEvent> events;
  events.reserve(changes.size());
  for (auto& [number, event] : changes) events.push_back(std::move(event));
  seen = n_changes_;
  return events;
}

}  // namespace knitmech::serve
