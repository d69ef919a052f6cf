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

Progress::Progress(const model::TensileTest& test, bool shown)
    : duration_(test.time_at(test.strain)),
      shown_(shown),
      on_terminal_(isatty(STDOUT_FILENO) == 1),
      start_(Clock::now()),
      drawn_(start_) {}

void Progress::update(const model::HistoryRow& row) {
  if (!shown_) return;
  const double share = std::clamp(row.time / duration_, 0.0, 1.0);
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

std::string Progress::line(const model::HistoryRow& row, double share) const {
  const std::chrono::duration<double> elapsed = Clock::now() - start_;
  const std::string left =
      share > 0 ? fmt::format("  time left {}", duration_text(elapsed.count() * (1 - share) / share)) : "";
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
