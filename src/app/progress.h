#pragma once

#include <chrono>
#include <string>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::app {

/// Shows on standard output how far a run is: on a terminal one line that is redrawn in place, otherwise a line for
/// every 10 % of the test.
class Progress {
 public:
  Progress(const model::TensileTest& test, bool shown);

  void update(const model::HistoryRow& row);

  /// Takes away the line on a terminal.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] std::string line(const model::HistoryRow& row, double share) const;
  void redraw(const std::string& text);

  double duration_;  ///< [s], of the test
  bool shown_;
  bool on_terminal_;
  Clock::time_point start_;
  Clock::time_point drawn_;
  std::size_t width_drawn_ = 0;
  int tenths_shown_ = 0;
};

}  // namespace knitmech::app
