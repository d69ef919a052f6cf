#include "serve/active_run.h"

#include <algorithm>
#include <exception>
#include <system_error>
#include <utility>

#include "base/errors.h"
#include "model/bending_measure.h"
#include "report/run_report.h"
#include "results/curve_stages.h"
#include "results/read_run.h"
#include "serve/constants.h"
#include "serve/refusal.h"

namespace knitmech::serve {
namespace {

double seconds_since_1970() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::vector<model::HistoryRow> rows_before(const run::RunStart& start) {
  return start.checkpoint ? start.checkpoint->record.history : std::vector<model::HistoryRow>{};
}

std::string sentences(const model::RunOutcome& outcome) {
  return outcome.advice.empty() ? outcome.reason : outcome.reason + " " + outcome.advice;
}

std::string name_of(model::RunStatus status) {
  switch (status) {
    case model::RunStatus::completed:
      return "completed";
    case model::RunStatus::interrupted:
      return "interrupted";
    case model::RunStatus::failed:
      break;
  }
  return "failed";
}

}  // namespace

ActiveRun::ActiveRun(std::string id, run::RunStart start, double seconds_before, Surroundings around)
    : id_(std::move(id)),
      start_(std::move(start)),
      around_(std::move(around)),
      ticket_(around_.turns.line_up()),
      rows_(rows_before(start_)),
      settings_(run::resolved_settings(start_.loaded, 1)),
      time_left_(start_.resumed_at().value_or(0) / start_.loaded.model.test.strain),
      seconds_before_(seconds_before),
      modified_(seconds_since_1970()),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

void ActiveRun::work(const std::stop_token& stop) {
  try {
    if (take_turn(stop)) {
      simulate(stop);
    } else {
      // A run that never began leaves nothing; a folder with something in it stays.
      std::error_code ignored;
      std::filesystem::remove(start_.folder, ignored);
      end("interrupted", "");
    }
  } catch (const std::exception& error) {
    end("failed", error.what());
  }
  give_turn_back();
  around_.changed();
}

bool ActiveRun::take_turn(const std::stop_token& stop) {
  has_turn_ = around_.turns.take(ticket_, stop);
  if (has_turn_) enter(Phase::running);
  return has_turn_;
}

void ActiveRun::give_turn_back() {
  if (has_turn_) around_.turns.give_back();
  has_turn_ = false;
}

void ActiveRun::simulate(const std::stop_token& stop) {
  const std::optional<int> threads = around_.turns.is_alone() ? std::nullopt : std::optional(1);
  const run::RunSettings settings{run::resolved_settings(start_.loaded, threads), around_.pictures};
  {
    const std::lock_guard lock(mutex_);
    settings_ = settings.simulation;
  }
  run::RunListener listener;
  listener.on_history = [this](const model::HistoryRow& row) { keep_row(row); };
  listener.keep_going = [this, &stop] { return keep_going(stop); };
  listener.wants_view = [this] { return wants_view(); };
  listener.on_view = [this](model::Frame frame) { keep_view(std::move(frame)); };
  finish(run::run_case(start_, settings, listener));
}

void ActiveRun::finish(const run::RunResult& result) {
  const std::string status = name_of(result.outcome.status);
  std::string message;
  enter(Phase::finishing);
  if (around_.pictures && result.outcome.status != model::RunStatus::interrupted) {
    try {
      report::write_run_report(results::read_run(start_.folder), around_.turns.is_alone() ? 0 : 1);
    } catch (const std::exception& error) {
      message = sentences(result.outcome);
      message += (message.empty() ? "" : " ") + std::string("There is no report: ") + error.what();
    }
  }
  end(status, message);
}

void ActiveRun::end(const std::string& status, const std::string& message) {
  {
    const std::lock_guard lock(mutex_);
    end_status_ = status;
    message_ = message;
  }
  enter(Phase::ended);
}

void ActiveRun::enter(Phase phase) {
  {
    const std::lock_guard lock(mutex_);
    if (phase_ == Phase::running) seconds_run_ = seconds() - seconds_before_;
    phase_ = phase;
    running_since_ = Clock::now();
    modified_ = seconds_since_1970();
  }
  around_.changed();
}

bool ActiveRun::keep_going(const std::stop_token& stop) {
  bool is_wanted = false;
  {
    const std::lock_guard lock(mutex_);
    is_wanted = pause_wanted_;
  }
  if (is_wanted && !stop.stop_requested()) wait_while_paused(stop);
  return !stop.stop_requested();
}

/// A run that stands still lets another one go.
void ActiveRun::wait_while_paused(const std::stop_token& stop) {
  give_turn_back();
  enter(Phase::paused);
  {
    std::unique_lock lock(mutex_);
    if (!resumed_.wait(lock, stop, [this] { return !pause_wanted_; })) return;
  }
  ticket_ = around_.turns.line_up();
  enter(Phase::waiting);
  static_cast<void>(take_turn(stop));
}

void ActiveRun::keep_row(const model::HistoryRow& row) {
  const std::lock_guard lock(mutex_);
  rows_.push_back(row);
  time_left_.update(row.strain / model().test.strain, seconds() - seconds_before_);
}

bool ActiveRun::wants_view() {
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  const bool is_watched = watched_ && now - *watched_ < kWatchedFor;
  if (!pause_wanted_ && (!is_watched || now < next_view_)) return false;
  view_began_ = now;
  return true;
}

void ActiveRun::keep_view(model::Frame frame) {
  auto kept = std::make_shared<const model::Frame>(std::move(frame));
  const std::lock_guard lock(mutex_);
  view_ = {view_.number + 1, std::move(kept)};
  const Clock::time_point now = Clock::now();
  next_view_ = view_began_ + std::max<Clock::duration>(kViewInterval, kViewRest * (now - view_began_));
}

double ActiveRun::seconds() const {
  const bool runs = phase_ == Phase::running;
  const std::chrono::duration<double> now = runs ? Clock::now() - running_since_ : Clock::duration::zero();
  return seconds_before_ + seconds_run_ + now.count();
}

std::string ActiveRun::status() const {
  switch (phase_) {
    case Phase::waiting:
      return "waiting";
    case Phase::running:
    case Phase::finishing:
      return "running";
    case Phase::paused:
      return "paused";
    case Phase::ended:
      break;
  }
  return end_status_;
}

RunHead ActiveRun::head() const {
  const std::lock_guard lock(mutex_);
  RunHead head;
  head.id = id_;
  head.title = model().title;
  head.status = status();
  head.active = phase_ != Phase::ended;
  head.strain = rows_.empty() ? 0 : rows_.back().strain;
  head.target_strain = model().test.strain;
  head.rows = rows_.size();
  head.live = view_.number;
  head.seconds = seconds();
  if (phase_ == Phase::running) {
    const double share = std::min(1.0, head.strain / head.target_strain);
    head.seconds_left = time_left_.seconds_left(share, head.seconds - seconds_before_);
  }
  head.message = message_;
  head.modified = modified_;
  return head;
}

RunDetail ActiveRun::detail() const {
  RunDetail detail;
  detail.head = head();
  detail.case_text = start_.case_text;
  detail.gauge_length = model().test.gauge_length;
  detail.nodes = model().n_nodes();
  detail.elements = model().n_elements();
  const std::vector<model::HistoryRow> rows = history(0);
  if (!rows.empty()) {
    detail.width = rows.front().width;
    detail.stages = results::curve_stages(rows, model::bending_measure(model())).stages;
  }
  const std::lock_guard lock(mutex_);
  detail.mass_scaling = settings_.mass_scaling;
  if (phase_ != Phase::waiting) detail.threads = settings_.threads;
  return detail;
}

std::vector<model::HistoryRow> ActiveRun::history(std::size_t from) const {
  const std::lock_guard lock(mutex_);
  return {rows_.begin() + static_cast<std::ptrdiff_t>(std::min(from, rows_.size())), rows_.end()};
}

LiveView ActiveRun::watch() {
  const std::lock_guard lock(mutex_);
  watched_ = Clock::now();
  return view_;
}

void ActiveRun::pause() {
  const std::lock_guard lock(mutex_);
  if (phase_ == Phase::waiting) throw Refusal(409, id_ + " waits for another run to end and does not run yet");
  if (phase_ == Phase::finishing || phase_ == Phase::ended) throw Refusal(409, id_ + " has come to its end");
  if (thread_.get_stop_token().stop_requested()) throw Refusal(409, id_ + " is being stopped");
  pause_wanted_ = true;
}

void ActiveRun::resume() {
  {
    const std::lock_guard lock(mutex_);
    if (phase_ == Phase::finishing || phase_ == Phase::ended) throw Refusal(409, id_ + " has come to its end");
    pause_wanted_ = false;
  }
  resumed_.notify_all();
}

void ActiveRun::stop() {
  thread_.request_stop();
}

bool ActiveRun::has_ended() const {
  const std::lock_guard lock(mutex_);
  return phase_ == Phase::ended;
}

bool ActiveRun::has_message() const {
  const std::lock_guard lock(mutex_);
  return !message_.empty();
}

}  // namespace knitmech::serve
