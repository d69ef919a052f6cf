#pragma once

#include <chrono>
#include <string>

#include "model/frame.h"
#include "model/model.h"
#include "run/time_left.h"

namespace knitmech::app {

/// Shows on standard output how far a run is: on a terminal one line that is redrawn in place, otherwise a line for
/// every 10 % of the test.
class Progress {
 public:
  /// \param strain at which the run begins [-]; not 0 where it goes on with an earlier one
  Progress(const model::TensileTest& test, double strain, bool shown);

  void update(const model::HistoryRow& row);

  /// Takes away the line on a terminal.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] double seconds() const;
  [[nodiscard]] std::string line(const model::HistoryRow& row, double share) const;
  void redraw(const std::string& text);

  double strain_;  ///< [-], at the end of the test
  bool shown_;
  bool on_terminal_;
  Clock::time_point start_;
  Clock::time_point drawn_;
  std::size_t width_drawn_ = 0;
  run::TimeLeft time_left_;
  int tenths_shown_ = 0;
};

}  // namespace knitmech::app
