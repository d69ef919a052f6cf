#include "study/run_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <numeric>
#include <system_error>
#include <thread>
#include <utility>

#include "base/errors.h"
#include "model/build_model.h"
#include "model/case_file.h"
#include "results/atomic_file.h"
#include "results/checkpoint_file.h"
#include "results/summary.h"
#include "run/run_case.h"
#include "study/study_folder.h"

namespace knitmech::study {
namespace {

namespace fs = std::filesystem;

/// The case of a run folder but for what does not change its results; empty if it has none that can be read.
std::optional<model::Case> case_in(const fs::path& folder) {
  const fs::path file = folder / "case.toml";
  if (!fs::is_regular_file(file)) return std::nullopt;
  try {
    return model::read_case_file(file);
  } catch (const std::exception&) {
    return std::nullopt;  // of another version of the program, or changed by hand: it is run anew
  }
}

bool has_the_case(const fs::path& folder, const Variant& variant) {
  std::optional<model::Case> before = case_in(folder);
  if (!before || !results::is_summary(folder / results::kSummaryFile)) return false;
  before->output.checkpoint_every = variant.input.output.checkpoint_every;
  return model::first_difference(*before, variant.input) == nullptr;
}

/// Elements of a case, nearly: what its run takes goes with them.
double size_of(const Variant& variant) {
  const model::Case::Fabric& fabric = variant.input.fabric;
  return static_cast<double>(fabric.wales) * fabric.courses * fabric.elements_per_erc;
}

/// One study under way.
class Runner {
 public:
  Runner(const Study& study, const StudySettings& settings, const StudyListener& listener)
      : study_(study), settings_(settings), listener_(listener) {
    for (Variant& variant : variants_of(study)) {
      fs::path folder = settings.folder / kRunsFolder / variant.name;
      states_.emplace_back();
      states_.back().variant = std::move(variant);
      states_.back().folder = std::move(folder);
    }
    order_.resize(states_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, [&](std::size_t a, std::size_t b) {
      return size_of(states_[a].variant) > size_of(states_[b].variant);
    });
  }

  std::vector<VariantState> run() {
    {
      const auto n_jobs = std::min(static_cast<std::size_t>(std::max(settings_.jobs, 1)), states_.size());
      std::vector<std::jthread> workers;
      for (std::size_t i = 0; i < n_jobs; ++i) workers.emplace_back([this] { work(); });
    }
    if (trouble_) std::rethrow_exception(trouble_);
    write_tables(settings_.folder, study_, states_);
    return std::move(states_);
  }

 private:
  [[nodiscard]] bool keeps_going() const { return !ends_ && (!listener_.keep_going || listener_.keep_going()); }

  /// The work of one thread. What goes wrong beyond one variant ends the study.
  void work() {
    try {
      for (std::size_t i = next_++; i < order_.size() && keeps_going(); i = next_++) run_one(states_[order_[i]]);
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!trouble_) trouble_ = std::current_exception();
      ends_ = true;
    }
  }

  void change(VariantState& state, Standing standing, std::string reason = {}) {
    const bool has_run = standing == Standing::completed || standing == Standing::failed;
    std::vector<Measure> measures;
    if (has_run) measures = measures_of(state.folder, study_.strains);
    const std::scoped_lock lock(mutex_);
    state.standing = standing;
    state.reason = std::move(reason);
    state.measures = std::move(measures);
    if (standing != Standing::running) write_tables(settings_.folder, study_, states_);
    if (listener_.on_change) listener_.on_change(state);
  }

  /// Takes the outcome of an earlier run of the same case. \return whether there is one
  bool take_earlier(VariantState& state) {
    if (!has_the_case(state.folder, state.variant)) return false;
    const std::string status = results::status_in_summary(state.folder / results::kSummaryFile);
    if (status != "completed" && status != "failed") return false;
    state.was_done = true;
    const bool is_completed = status == "completed";
    change(state, is_completed ? Standing::completed : Standing::failed,
           is_completed ? "" : results::reason_in_summary(state.folder / results::kSummaryFile));
    return true;
  }

  [[nodiscard]] static run::RunStart start_of(const VariantState& state) {
    const bool goes_on =
        has_the_case(state.folder, state.variant) && fs::exists(state.folder / results::kCheckpointFile);
    if (goes_on) {
      try {
        return run::earlier_run(state.folder);
      } catch (const InputError&) {
        // A checkpoint of another version, or damaged: the run starts anew, which costs time and nothing else.
      }
    }
    return run::run_of(state.variant.input, state.folder);
  }

  void run_one(VariantState& state) {
    if (!state.variant.complaint.empty()) return change(state, Standing::impossible, state.variant.complaint);
    if (take_earlier(state)) return;
    const auto [standing, reason] = outcome_of(state);
    change(state, standing, reason);
  }

  /// Runs a variant. \return how that went, and why not better
  std::pair<Standing, std::string> outcome_of(VariantState& state) {
    try {
      return simulate(state);
    } catch (const InputError& error) {
      return {Standing::impossible, error.what()};
    } catch (const std::bad_alloc&) {
      return {Standing::failed, "The memory of this computer is too small for it."};
    } catch (const std::exception& error) {
      return {Standing::failed, error.what()};
    }
  }

  std::pair<Standing, std::string> simulate(VariantState& state) {
    run::RunStart start = start_of(state);
    change(state, Standing::running);
    run::RunListener listener;
    listener.on_history = [&](const model::HistoryRow& row) {
      const std::scoped_lock lock(mutex_);
      if (listener_.on_history) listener_.on_history(state, row);
    };
    listener.keep_going = [this] { return keeps_going(); };
    const run::RunSettings settings{.simulation = run::resolved_settings(start.loaded, settings_.threads),
                                    .pictures = false};
    const run::RunResult result = run::run_case(start, settings, listener);
    switch (result.outcome.status) {
      case model::RunStatus::completed:
        return {Standing::completed, ""};
      case model::RunStatus::interrupted:
        return {Standing::pending, ""};
      case model::RunStatus::failed:
        break;
    }
    return {Standing::failed, result.outcome.reason};
  }

  const Study& study_;
  const StudySettings& settings_;
  const StudyListener& listener_;
  std::vector<VariantState> states_;
  std::vector<std::size_t> order_;  ///< in which they are run
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> ends_ = false;
  std::exception_ptr trouble_;  ///< the first
  std::mutex mutex_;            ///< for what stands in states_, and for the listener
};

}  // namespace

const char* name_of(Standing standing) {
  switch (standing) {
    case Standing::pending:
      return "pending";
    case Standing::running:
      return "running";
    case Standing::completed:
      return "completed";
    case Standing::failed:
      return "failed";
    case Standing::impossible:
      return "impossible";
  }
  return "";
}

std::vector<VariantState> run_study(const Study& study, const StudySettings& settings, const StudyListener& listener) {
  prepare_folder(settings.folder, study);
  return Runner(study, settings, listener).run();
}

}  // namespace knitmech::study
