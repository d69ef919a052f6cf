#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "model/frame.h"
#include "model/model.h"
#include "run/run_case.h"
#include "run/run_start.h"
#include "run/time_left.h"
#include "serve/run_json.h"
#include "serve/turns.h"

namespace knitmech::serve {

/// What a watcher sees of a run.
struct LiveView {
  int number = 0;  ///< from 1
  std::shared_ptr<const model::Frame> frame;
};

/// A run on a thread of its own, which waits for its turn, simulates, and writes the report. All members may be called
/// from any thread. Whatever goes wrong on its thread is told by its head.
class ActiveRun {
 public:
  struct Surroundings {
    Turns& turns;                   ///< outlives the run
    std::function<void()> changed;  ///< called on any thread when the status changes
    bool pictures = true;           ///< and a report
  };

  /// \param seconds_before that an earlier run took, with which it goes on [s]
  ActiveRun(std::string id, run::RunStart start, double seconds_before, Surroundings around);

  /// Interrupts the run and waits for it.
  ~ActiveRun() = default;
  ActiveRun(const ActiveRun&) = delete;
  ActiveRun& operator=(const ActiveRun&) = delete;
  ActiveRun(ActiveRun&&) = delete;
  ActiveRun& operator=(ActiveRun&&) = delete;

  /// Without the number of frames, which are on the disk.
  [[nodiscard]] RunHead head() const;
  /// What the program knows of the run besides its files; without frames.
  [[nodiscard]] RunDetail detail() const;
  [[nodiscard]] std::vector<model::HistoryRow> history(std::size_t from) const;
  [[nodiscard]] const model::Model& model() const { return start_.loaded.model; }
  [[nodiscard]] const std::filesystem::path& folder() const { return start_.folder; }

  /// The newest view, and the wish for further ones for a while.
  [[nodiscard]] LiveView watch();

  /// All do nothing if it is so already. Throw Refusal with 409 in a state that does not admit it.
  void pause();
  void resume();
  void stop();

  /// Whether its thread is done.
  [[nodiscard]] bool has_ended() const;
  /// Whether it has something to say that is not in its folder.
  [[nodiscard]] bool has_message() const;

 private:
  using Clock = std::chrono::steady_clock;
  enum class Phase { waiting, running, paused, finishing, ended };

  void work(const std::stop_token& stop);
  void simulate(const std::stop_token& stop);
  void finish(const run::RunResult& result);
  void end(const std::string& status, const std::string& message);
  [[nodiscard]] bool take_turn(const std::stop_token& stop);
  void give_turn_back();
  [[nodiscard]] bool keep_going(const std::stop_token& stop);
  void wait_while_paused(const std::stop_token& stop);
  void keep_row(const model::HistoryRow& row);
  [[nodiscard]] bool wants_view();
  void keep_view(model::Frame frame);
  void enter(Phase phase);
  [[nodiscard]] double seconds() const;
  [[nodiscard]] std::string status() const;

  std::string id_;
  run::RunStart start_;
  Surroundings around_;
  Turns::Ticket ticket_;
  bool has_turn_ = false;  ///< for its thread alone

  mutable std::mutex mutex_;  ///< for what follows
  std::condition_variable_any resumed_;
  Phase phase_ = Phase::waiting;
  std::string end_status_, message_;
  bool pause_wanted_ = false;
  std::vector<model::HistoryRow> rows_;
  solve::SimulationSettings settings_;
  run::TimeLeft time_left_;
  double seconds_before_, seconds_run_ = 0;  ///< [s], of an earlier run; of this one up to running_since_
  Clock::time_point running_since_;
  double modified_;  ///< [s] since 1970
  std::optional<Clock::time_point> watched_;
  Clock::time_point view_began_, next_view_;
  LiveView view_;

  std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace knitmech::serve
