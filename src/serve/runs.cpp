#include "serve/runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <thread>
#include <utility>

#include "base/text.h"
#include "model/case_file.h"
#include "report/run_report.h"
#include "results/checkpoint_file.h"
#include "results/read_frame.h"
#include "results/run_folder.h"
#include "run/load_case.h"
#include "serve/active_run.h"
#include "serve/bell.h"
#include "serve/constants.h"
#include "serve/export_file.h"
#include "serve/frame_blob.h"
#include "serve/new_folder.h"
#include "serve/refusal.h"
#include "serve/run_board.h"
#include "serve/run_json.h"
#include "serve/run_picture.h"
#include "serve/stored_runs.h"
#include "serve/turns.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using ActiveRunPointer = std::shared_ptr<ActiveRun>;
using Heads = std::map<std::string, RunHead>;

int processors(int at_once) {
  return at_once > 0 ? at_once : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Of a run whose thread has ended with a message of its own, which its folder does not know.
void tell_whether_it_can_go_on(RunHead& head, const fs::path& folder) {
  std::error_code ignored;
  const bool has_checkpoint = fs::exists(folder / results::kCheckpointFile, ignored);
  head.can_go_on = has_checkpoint && head.status != "completed";
}

RunHead head_of(const ActiveRun& run) {
  RunHead head = run.head();
  if (!head.active) tell_whether_it_can_go_on(head, run.folder());
  // A run that waits has no folder with frames of its own yet; of one whose files are gone the run itself will tell.
  try {
    head.frames = frames_in(run.folder()).size();
  } catch (const std::exception&) {
    head.frames = 0;
  }
  return head;
}

std::vector<RunHead> newest_first(const Heads& heads) {
  std::vector<RunHead> list;
  for (const auto& [id, head] : heads) list.push_back(head);
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.modified > b.modified; });
  return list;
}

run::RunStart earlier_run(const fs::path& folder, const std::string& id) {
  try {
    return run::earlier_run(folder);
  } catch (const model::CaseFileError&) {
    throw;
  } catch (const InputError& error) {
    throw Refusal(409, fmt::format("{} cannot go on: {}", id, error.what()));
  }
}

}  // namespace

class Runs::State {
 public:
  State(fs::path root, RunsOptions options)
      : root_(std::move(root)), options_(options), turns_(processors(options.at_once)), stored_(root_) {}

  ~State() {
    turns_.close();                                   // or one that waits would begin when another ends
    for (const auto& [id, run] : runs_) run->stop();  // all of them before the first is waited for
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  State(State&&) = delete;
  State& operator=(State&&) = delete;

  [[nodiscard]] StoredRuns& stored() { return stored_; }

  /// The run with an id as long as its thread is at it; empty if there is none.
  [[nodiscard]] ActiveRunPointer active(const std::string& id) {
    ActiveRunPointer run = known(id);
    return run && !run->has_ended() ? run : nullptr;
  }

  /// The same, of a run that this program runs or has run.
  [[nodiscard]] ActiveRunPointer known(const std::string& id) {
    const std::lock_guard lock(runs_mutex_);
    const auto found = runs_.find(id);
    return found == runs_.end() ? nullptr : found->second;
  }

  /// Throws Refusal with 404 or 409 if the run is not active.
  [[nodiscard]] ActiveRunPointer active_for_command(const std::string& id) {
    if (ActiveRunPointer run = active(id)) return run;
    static_cast<void>(stored_.folder_of(id));
    throw Refusal(409, id + " does not run here");
  }

  [[nodiscard]] Heads heads() { return with_active(stored_.heads()); }

  std::string start(std::string_view case_text, std::string_view name) {
    run::LoadedCase loaded = run::load_case_text(case_text, results::kCaseFile);
    const fs::path folder = make_new_folder(root_, folder_name(name));
    std::string id = folder.filename().string();
    try {
      begin(id, run::new_run(std::move(loaded), folder), 0);
    } catch (...) {
      std::error_code ignored;
      fs::remove(folder, ignored);
      throw;
    }
    return id;
  }

  void go_on(const std::string& id) {
    const fs::path folder = stored_.folder_of(id);
    const RunHead head = stored_.head(id);
    const ActiveRunPointer before = known(id);
    const bool is_ours = before && before->has_ended();
    if (!is_ours && !head.can_go_on) throw Refusal(409, fmt::format("{} cannot go on: it is {}", id, head.status));
    // What is stored is time in the solver alone; the time shown goes on from that shown before.
    begin(id, earlier_run(folder, id), is_ours ? before->head().seconds : head.seconds);
  }

  [[nodiscard]] std::vector<RunEvent> wait_for_changes(std::uint64_t& seen, std::chrono::milliseconds longest) {
    const Clock::time_point until = Clock::now() + longest;
    const bool wants_state = seen == 0;
    while (true) {
      const std::uint64_t n_rings = bell_.n_rings();
      const Clock::time_point next_look = look();
      std::vector<RunEvent> events = board_.since(seen);
      if (!events.empty() || wants_state || Clock::now() >= until) return events;
      bell_.wait(n_rings, std::min(until, next_look));
    }
  }

  void drop_ended_runs() {
    // Ended after the lock is gone: their threads may still have a word to say.
    std::vector<ActiveRunPointer> ended;
    const std::lock_guard lock(runs_mutex_);
    for (auto run = runs_.begin(); run != runs_.end();) {
      if (is_told_by_its_folder(*run->second)) {
        ended.push_back(std::move(run->second));
        run = runs_.erase(run);
      } else {
        ++run;
      }
    }
  }

 private:
  [[nodiscard]] static bool is_told_by_its_folder(const ActiveRun& run) {
    std::error_code ignored;
    return run.has_ended() && (!run.has_message() || !fs::exists(run.folder(), ignored));
  }

  void begin(const std::string& id, run::RunStart start, double seconds_before) {
    {
      const std::lock_guard lock(runs_mutex_);
      const auto before = runs_.find(id);
      if (before != runs_.end() && !before->second->has_ended()) throw Refusal(409, id + " runs already");
      const ActiveRun::Surroundings around{turns_, [this] { bell_.ring(); }, options_.pictures};
      runs_.insert_or_assign(id, std::make_shared<ActiveRun>(id, std::move(start), seconds_before, around));
    }
    bell_.ring();
  }

  /// What this program knows of its own runs takes the place of what is stored.
  [[nodiscard]] Heads with_active(Heads heads) {
    drop_ended_runs();
    const std::lock_guard lock(runs_mutex_);
    for (const auto& [id, run] : runs_) heads[id] = head_of(*run);
    return heads;
  }

  /// Brings the board up to date, unless that was done just now. Returns when to look again.
  Clock::time_point look() {
    const std::lock_guard lock(look_mutex_);
    const Clock::time_point now = Clock::now();
    const std::uint64_t n_rings = bell_.n_rings();
    const bool has_rung = n_rings != rings_seen_;
    if (!has_rung && now < next_look_) return next_look_;
    if (has_rung || now >= next_folder_look_) {
      stored_heads_ = stored_.heads();
      next_folder_look_ = now + kFolderInterval;
    }
    rings_seen_ = n_rings;
    board_.set(with_active(stored_heads_));
    next_look_ = has_active() ? now + kLookInterval : next_folder_look_;
    return next_look_;
  }

  [[nodiscard]] bool has_active() {
    const std::lock_guard lock(runs_mutex_);
    return std::any_of(runs_.begin(), runs_.end(), [](const auto& run) { return !run.second->has_ended(); });
  }

  fs::path root_;
  RunsOptions options_;
  Turns turns_;
  Bell bell_;
  StoredRuns stored_;
  RunBoard board_;

  std::mutex look_mutex_;  ///< for what follows
  std::uint64_t rings_seen_ = 0;
  Clock::time_point next_look_{}, next_folder_look_{};
  Heads stored_heads_;

  std::mutex runs_mutex_;
  std::map<std::string, ActiveRunPointer> runs_;  ///< last, so that they end first
};

Runs::Runs(fs::path folder, RunsOptions options) : state_(std::make_unique<State>(std::move(folder), options)) {}

Runs::~Runs() = default;

std::string Runs::list_json() {
  return serve::list_json(newest_first(state_->heads()));
}

std::string Runs::detail_json(const std::string& id) {
  const ActiveRunPointer run = state_->known(id);
  if (!run || run->has_ended()) {
    RunDetail detail = state_->stored().detail(id);
    if (run && run->has_message()) detail.head = head_of(*run);
    return serve::detail_json(detail);
  }
  static_cast<void>(run->watch());
  RunDetail detail = run->detail();
  detail.head = head_of(*run);
  detail.frames = frames_in(run->folder());
  return serve::detail_json(detail);
}

std::string Runs::history_json(const std::string& id, std::size_t from) {
  const ActiveRunPointer run = state_->active(id);
  return serve::history_json(run ? run->history(from) : state_->stored().history(id, from), from);
}

std::string Runs::model_blob(const std::string& id) {
  if (const ActiveRunPointer run = state_->active(id)) return serve::model_blob(run->model());
  return serve::model_blob(state_->stored().read(id)->model);
}

std::string Runs::frame_blob(const std::string& id, int index) {
  const auto run = state_->stored().read(id);
  const auto has_index = [index](const results::StoredFrame& frame) { return frame.index == index; };
  if (std::none_of(run->frames.begin(), run->frames.end(), has_index)) {
    throw Refusal(404, fmt::format("{} has no frame {}", id, index));
  }
  return serve::frame_blob(run->model, results::read_frame(*run, index), 0);
}

std::string Runs::live_blob(const std::string& id) {
  const ActiveRunPointer run = state_->active(id);
  const LiveView view = run ? run->watch() : LiveView{};
  if (!view.frame) throw Refusal(404, fmt::format("there is no live view of {}", base::in_quotes(id)));
  return serve::frame_blob(run->model(), *view.frame, view.number);
}

std::string Runs::start(std::string_view case_text, std::string_view name) {
  return state_->start(case_text, name);
}

void Runs::pause(const std::string& id) {
  state_->active_for_command(id)->pause();
}

void Runs::resume(const std::string& id) {
  if (const ActiveRunPointer run = state_->active(id)) {
    run->resume();
  } else {
    state_->go_on(id);
  }
}

void Runs::stop(const std::string& id) {
  state_->active_for_command(id)->stop();
}

void Runs::write_report(const std::string& id) {
  if (state_->active(id)) throw Refusal(409, id + " is still under way");
  report::write_run_report(*state_->stored().read(id));
}

std::string Runs::geometry(const std::string& id, const RequestWords& words) {
  return run_geometry(*state_->stored().read(id), words);
}

std::string Runs::picture_png(const std::string& id, const RequestWords& words) {
  return run_picture_png(*state_->stored().read(id), words);
}

fs::path Runs::folder_of(const std::string& id) {
  return state_->stored().folder_of(id);
}

std::vector<RunEvent> Runs::wait_for_changes(std::uint64_t& seen, std::chrono::milliseconds longest) {
  return state_->wait_for_changes(seen, longest);
}

}  // namespace knitmech::serve
