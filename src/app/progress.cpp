#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/run_texts.h"

namespace knitmech::app {
namespace {

constexpr std::chrono::milliseconds kRedrawInterval{100};
constexpr int kBarWidth = 24;
/// Share of the test between two marks, by which the time left is estimated.
constexpr double kMarkInterval = 0.05;

std::string bar(double share) {
  const auto full = static_cast<std::size_t>(share * kBarWidth);
  return "[" + std::string(full, '#') + std::string(kBarWidth - full, '.') + "]";
}

}  // namespace

Progress::Progress(const model::TensileTest& test, double strain, bool shown)
    : strain_(test.strain),
      shown_(shown),
      on_terminal_(isatty(STDOUT_FILENO) == 1),
      start_(Clock::now()),
      drawn_(start_),
      mark_{strain / test.strain, start_},
      earlier_mark_(mark_) {}

void Progress::update(const model::HistoryRow& row) {
  if (!shown_) return;
  const double share = std::clamp(row.strain / strain_, 0.0, 1.0);
  set_mark(share);
  if (on_terminal_) {
    if (Clock::now() - drawn_ < kRedrawInterval) return;
    drawn_ = Clock::now();
    redraw(bar(share) + line(row, share));
    return;
  }
  const int tenths = static_cast<int>(share * 10);
  if (tenths <= tenths_shown_) return;
  tenths_shown_ = tenths;
  fmt::print("{}\n", line(row, share));
  std::fflush(stdout);
}

void Progress::finish() {
  if (!shown_ || !on_terminal_ || width_drawn_ == 0) return;
  redraw({});
  fmt::print("\r");
  std::fflush(stdout);
}

void Progress::set_mark(double share) {
  if (share < mark_.share + kMarkInterval) return;
  earlier_mark_ = mark_;
  mark_ = {share, Clock::now()};
}

double Progress::time_left(double share) const {
  const std::chrono::duration<double> elapsed = Clock::now() - earlier_mark_.time;
  return elapsed.count() * (1 - share) / (share - earlier_mark_.share);
}

std::string Progress::line(const model::HistoryRow& row, double share) const {
  const std::string left =
      share > earlier_mark_.share ? fmt::format("  time left {}", duration_text(time_left(share))) : "";
  return fmt::format(" {:3.0f} %  strain {}  force {}{}", 100 * share, percent_text(row.strain),
                     force_text(row.force_top), left);
}

void Progress::redraw(const std::string& text) {
  const std::size_t width = std::max(width_drawn_, text.size());
  fmt::print("\r{:{}}", text, width);
  std::fflush(stdout);
  width_drawn_ = text.size();
}

}  // namespace knitmech::app
