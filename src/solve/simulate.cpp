#include "solve/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/freed_memory.h"
#include "model/places.h"
#include "solve/checkpoint.h"
#include "solve/constants.h"
#include "solve/explicit_solver.h"
#include "solve/mass_scaling.h"
#include "solve/threads.h"

namespace knitmech::solve {

namespace {

/// A strain at which something is to be reported.
struct Event {
  double strain;
  bool with_frame;
};

std::vector<Event> schedule(const model::TensileTest& test, const SimulationSettings& settings) {
  std::vector<Event> events;
  for (int i = 1; i <= settings.history_points; ++i) {
    events.push_back({test.strain * i / settings.history_points, i == settings.history_points});
  }
  for (const double strain : settings.frames_at) {
    if (strain < test.strain) events.push_back({strain, true});
  }
  std::sort(events.begin(), events.end(), [](Event a, Event b) { return a.strain < b.strain; });

  // Strains that agree up to rounding are one event.
  std::vector<Event> merged;
  const double same = 1e-9 * test.strain;
  for (const Event event : events) {
    if (!merged.empty() && event.strain - merged.back().strain < same) {
      merged.back().with_frame = merged.back().with_frame || event.with_frame;
    } else {
      merged.push_back(event);
    }
  }
  return merged;
}

struct Failure {
  std::string reason, advice;
};

/// What went wrong, if anything, in the step just done.
std::optional<Failure> failure_in_step(const model::Model& model, const ExplicitSolver& solver) {
  const bool collapsed = solver.step_length() < kStepCollapse * solver.first_step();
  if (solver.is_finite() && !solver.lost_crossing() && !collapsed) return std::nullopt;

  const std::string when =
      fmt::format("at {:.2f} % strain ({:.6g} s, step {})", 100 * solver.strain(), solver.time(), solver.steps());
  if (!solver.is_finite()) {
    return Failure{fmt::format("A velocity stopped being a number {}.", when),
                   "Try a smaller solver.step_factor, or less solver.mass_scaling."};
  }
  if (const auto& lost = solver.lost_crossing()) {
    return Failure{fmt::format("A yarn went through another {}: {} and {}, near ({:.3f}, {:.3f}, {:.3f}) mm.", when,
                               model::place_text(model, static_cast<std::size_t>(lost->first)),
                               model::place_text(model, static_cast<std::size_t>(lost->second)), lost->place.x,
                               lost->place.y, lost->place.z),
                   "Try a larger contact.stiffness, a smaller test.speed, or less solver.mass_scaling."};
  }
  return Failure{fmt::format("The stable time step fell to {:.3g} s {}, from {:.3g} s at the start.",
                             solver.step_length(), when, solver.first_step()),
                 "Yarns are pressed together or thrown about too hard: try a smaller test.speed, less "
                 "solver.mass_scaling, or end the test at a smaller test.strain."};
}

/// Whether more energy is in the fabric than was ever put in.
std::optional<Failure> failure_in_balance(const model::Model& model, const model::HistoryRow& row) {
  const double held = row.internal_energy + row.kinetic_energy + row.contact_energy + row.friction_loss +
                      row.damping_loss + row.break_loss;
  const yarn::Section& section = model.sections.front();
  const double noise = kEnergyNoise * section.bending_stiffness / section.diameter;
  if (std::isfinite(held) && held <= kEnergyBlowUp * std::abs(row.external_work) + noise) return std::nullopt;
  return Failure{
      fmt::format("The energy balance broke at {:.2f} % strain ({:.6g} s): {:.4g} mJ are in the fabric, but only "
                  "{:.4g} mJ were put in.",
                  100 * row.strain, row.time, held, row.external_work),
      "Try a smaller solver.step_factor, a smaller test.speed, or less solver.mass_scaling."};
}

class Run {
 public:
  Run(const model::Model& model, const SimulationSettings& settings, const SimulationCallbacks& callbacks)
      : model_(model),
        callbacks_(callbacks),
        events_(schedule(model.test, settings)),
        mass_scaling_(settings.mass_scaling ? *settings.mass_scaling : automatic_mass_scaling(model)),
        threads_(settings.threads ? *settings.threads : automatic_threads(model)),
        solver_(model, {mass_scaling_, settings.bulk_viscosity, settings.mass_damping, settings.step_factor,
                        settings.adapts_pace && mass_scaling_ > 1, threads_,
                        settings.selective_mass && mass_scaling_ > 1 ? selective_length(model) : 0}) {}

  model::RunOutcome run(std::string checkpoint) {
    if (checkpoint.empty()) {
      begin();
    } else {
      go_back_to(std::move(checkpoint), solver_, progress_);
      seconds_before_ = outcome_.wall_seconds;
    }
    outcome_.threads = threads_;
    base::hand_back_freed_memory();
    for (; progress_.next_report < events_.size(); ++progress_.next_report) {
      const Event& event = events_[progress_.next_report];
      const bool is_told = progress_.latest.strain >= event.strain;  // with the step to an event before
      if (is_told) {
        if (event.with_frame) report_frame();
        continue;
      }
      if (!advance_to(event.strain)) {
        report(true);
        break;
      }
      report(event.with_frame);
      if (const auto failure = failure_in_balance(model_, progress_.latest)) {
        fail(*failure);
        if (!event.with_frame) report_frame();
        break;
      }
    }
    outcome_.breaks = solver_.broken();
    outcome_.time = solver_.time();
    outcome_.strain = progress_.latest.strain;
    outcome_.steps = solver_.steps();
    outcome_.largest_penetration = solver_.largest_penetration();
    outcome_.lost_crossings = solver_.lost_crossing() ? 1 : 0;
    outcome_.crossing_checks = solver_.crossing_checks();
    outcome_.wall_seconds = seconds();
    return outcome_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void begin() {
    outcome_.mass_scaling = mass_scaling_;
    outcome_.smallest_step = solver_.first_step();
    report(true);
  }

  [[nodiscard]] double seconds() const {
    return seconds_before_ + std::chrono::duration<double>(Clock::now() - start_).count();
  }

  void report(bool with_frame) {
    progress_.latest = solver_.history();
    outcome_.largest_tie_stretch = std::max(outcome_.largest_tie_stretch, solver_.largest_tie_stretch());
    if (callbacks_.on_history) callbacks_.on_history(progress_.latest);
    if (with_frame) report_frame();
  }

  void report_frame() {
    if (callbacks_.on_frame) callbacks_.on_frame(solver_.frame(progress_.n_frames, progress_.latest));
    ++progress_.n_frames;
  }

  void note_ravelling() {
    for (model::Ravelling& event : solver_.take_ravelled()) {
      event.strain = solver_.strain();
      outcome_.ravelled.push_back(event);
    }
  }

  bool ended_by_break() {
    if (solver_.broken().empty() || model_.test.on_break != model::OnBreak::stop) return false;
    const model::YarnBreak& event = solver_.broken().front();
    outcome_.reason = fmt::format("The test ended at {:.2f} % strain because a yarn broke, in {}.", 100 * event.strain,
                                  model::element_text(model_, static_cast<std::size_t>(event.element)));
    return true;
  }

  void fail(const Failure& failure) {
    outcome_.status = model::RunStatus::failed;
    outcome_.reason = failure.reason;
    outcome_.advice = failure.advice;
  }

  /// Steps to the first instant that is not before a strain; false if the run has to end before. Steps are not cut to
  /// hit the strain: see ExplicitSolver::look_at_stable_step().
  bool advance_to(double strain) {
    while (solver_.strain() < strain) {
      solver_.step();
      note_ravelling();
      outcome_.smallest_step = std::min(outcome_.smallest_step, solver_.step_length());
      if (const auto failure = failure_in_step(model_, solver_)) {
        fail(*failure);
        return false;
      }
      if (ended_by_break()) return false;
      if (solver_.steps() % kAskInterval == 0 && !ask_whether_to_go_on()) return false;
    }
    return true;
  }

  void show_if_wanted() const {
    if (!callbacks_.on_view || !callbacks_.wants_view || !callbacks_.wants_view()) return;
    model::HistoryRow row = progress_.latest;
    row.time = solver_.time();
    row.displacement = solver_.displacement();
    row.strain = solver_.strain();
    constexpr int kNoStoredFrame = -1;
    callbacks_.on_view(solver_.frame(kNoStoredFrame, row));
  }

  bool keeps_going() {
    if (!callbacks_.keep_going) return true;
    const auto asked = Clock::now();
    const bool goes_on = callbacks_.keep_going(progress_.latest);
    start_ += Clock::now() - asked;
    return goes_on;
  }

  bool ask_whether_to_go_on() {
    show_if_wanted();
    const bool goes_on = keeps_going();
    const bool is_wanted = !goes_on || (callbacks_.wants_checkpoint && callbacks_.wants_checkpoint());
    if (is_wanted && callbacks_.on_checkpoint) {
      outcome_.wall_seconds = seconds();
      callbacks_.on_checkpoint(checkpoint_of(solver_, progress_));
    }
    if (!goes_on) outcome_.status = model::RunStatus::interrupted;
    return goes_on;
  }

  const model::Model& model_;
  const SimulationCallbacks& callbacks_;
  std::vector<Event> events_;
  double mass_scaling_;
  int threads_;
  ExplicitSolver solver_;
  RunProgress progress_;
  model::RunOutcome& outcome_ = progress_.outcome;
  Clock::time_point start_ = Clock::now();  ///< later by the time that the run has paused
  double seconds_before_ = 0;               ///< [s], in the solver, of the run that this one goes on with
};

}  // namespace

SimulationSettings settings_from(const model::Case& input) {
  return {input.solver.mass_scaling, input.solver.bulk_viscosity, input.solver.mass_damping,  input.solver.step_factor,
          input.output.frames_at,    input.output.history_points, !input.solver.mass_scaling, {},
          !input.solver.mass_scaling};
}

model::RunOutcome simulate(const model::Model& model, const SimulationSettings& settings,
                           const SimulationCallbacks& callbacks, std::string checkpoint) {
  return Run(model, settings, callbacks).run(std::move(checkpoint));
}

}  // namespace knitmech::solve
