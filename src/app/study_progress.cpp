#include "app/study_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "base/number_text.h"

namespace knitmech::app {
namespace {

constexpr std::chrono::milliseconds kRedrawInterval{200};

std::optional<double> measure(const study::VariantState& state, const char* name) {
  const auto found = std::ranges::find(state.measures, name, &study::Measure::name);
  return found == state.measures.end() ? std::nullopt : found->value;
}

}  // namespace

std::string standing_text(const study::VariantState& state) {
  if (state.standing != study::Standing::completed) {
    return state.reason.empty() ? name_of(state.standing)
                                : fmt::format("{}: {}", name_of(state.standing), state.reason);
  }
  std::string text = measure(state, "quasi_static") == 1.0 ? "quasi-static" : "NOT quasi-static";
  if (const auto work = measure(state, "work_mJ")) text += fmt::format(", work {:.4g} mJ", *work);
  if (const auto strain = measure(state, "strain")) text += fmt::format(" to {}", base::percent_text(*strain));
  if (state.was_done) return text + " (was done before)";
  if (const auto wall = measure(state, "wall_s")) text += fmt::format(", {}", base::duration_text(*wall));
  return text;
}

StudyProgress::StudyProgress(std::size_t n_variants, bool shown)
    : n_variants_(n_variants), shown_(shown), on_terminal_(isatty(STDOUT_FILENO) == 1), drawn_(Clock::now()) {}

void StudyProgress::change(const study::VariantState& state) {
  const std::string& name = state.variant.name;
  if (state.standing == study::Standing::running) {
    running_[name] = 0;
    return;
  }
  running_.erase(name);
  if (state.standing == study::Standing::pending) return;
  ++n_ended_;
  if (!shown_) return;
  finish();
  fmt::print("  {}/{} {}: {}\n", n_ended_, n_variants_, name, standing_text(state));
  std::fflush(stdout);
}

void StudyProgress::update(const study::VariantState& state, const model::HistoryRow& row) {
  running_[state.variant.name] = row.strain / state.variant.input.test.strain;
  if (!shown_ || !on_terminal_ || Clock::now() - drawn_ < kRedrawInterval) return;
  drawn_ = Clock::now();
  redraw(running_text());
}

std::string StudyProgress::running_text() const {
  std::string text = fmt::format("  {} of {} ended, running:", n_ended_, n_variants_);
  for (const auto& [name, share] : running_) text += fmt::format(" {} {:.0f} %", name, 100 * share);
  constexpr std::size_t kWidest = 110;
  return text.size() > kWidest ? text.substr(0, kWidest) + "..." : text;
}

void StudyProgress::redraw(const std::string& text) {
  fmt::print("\r{:<{}}", text, width_drawn_);
  std::fflush(stdout);
  width_drawn_ = text.size();
}

void StudyProgress::finish() {
  if (width_drawn_ == 0) return;
  redraw({});
  width_drawn_ = 0;
  fmt::print("\r");
  std::fflush(stdout);
}

}  // namespace knitmech::app
