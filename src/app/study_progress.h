#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <string>

#include "model/frame.h"
#include "study/run_study.h"

namespace knitmech::app {

/// Shows on standard output how far a study is: a line for each run that has ended, and on a terminal one below that is
/// redrawn in place.
class StudyProgress {
 public:
  StudyProgress(std::size_t n_variants, bool shown);

  void change(const study::VariantState& state);
  void update(const study::VariantState& state, const model::HistoryRow& row);

  /// Takes away the line on a terminal.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void redraw(const std::string& text);
  [[nodiscard]] std::string running_text() const;

  std::size_t n_variants_, n_ended_ = 0;
  bool shown_, on_terminal_;
  std::map<std::string, double> running_;  ///< share of the test by name of the run
  Clock::time_point drawn_;
  std::size_t width_drawn_ = 0;
};

/// "completed, quasi-static, 7.35 mN at the end": how a run of a study has ended, in a few words.
[[nodiscard]] std::string standing_text(const study::VariantState& state);

}  // namespace knitmech::app
