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
      time_left_(strain / test.strain) {}

void Progress::update(const model::HistoryRow& row) {
  if (!shown_) return;
  const double share = std::clamp(row.strain / strain_, 0.0, 1.0);
  time_left_.update(share, seconds());
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

double Progress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::string Progress::line(const model::HistoryRow& row, double share) const {
  const auto seconds_left = time_left_.seconds_left(share, seconds());
  const std::string left = seconds_left ? fmt::format("  time left {}", duration_text(*seconds_left)) : "";
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
