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
  /// \param strain at which the run begins [-]; not 0 where it goes on with an earlier one
  Progress(const model::TensileTest& test, double strain, bool shown);

  void update(const model::HistoryRow& row);

  /// Takes away the line on a terminal.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void set_mark(double share);
  /// [s], as if the run went on as it did of late; the pace of a test may change.
  [[nodiscard]] double time_left(double share) const;
  [[nodiscard]] std::string line(const model::HistoryRow& row, double share) const;
  void redraw(const std::string& text);

  double strain_;  ///< [-], at the end of the test
  bool shown_;
  bool on_terminal_;
  Clock::time_point start_;
  Clock::time_point drawn_;
  std::size_t width_drawn_ = 0;
  /// Where the run was: at the last mark, and at the one before.
  struct Mark {
    double share = 0;
    Clock::time_point time;
  };
  Mark mark_, earlier_mark_;
  int tenths_shown_ = 0;
};

}  // namespace knitmech::app
