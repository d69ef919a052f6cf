#pragma once

#include <optional>

namespace knitmech::run {

/// Estimates how long a run still takes, as if it went on as it did of late; the pace of a test may change.
class TimeLeft {
 public:
  /// \param share of the test that is done when the clock starts [-]; not 0 where an earlier run is gone on with
  explicit TimeLeft(double share) : mark_{share, 0}, earlier_mark_(mark_) {}

  /// \param share done [-] \param seconds that it has run since the clock started [s]
  void update(double share, double seconds);

  /// [s]; empty as long as nothing was done.
  [[nodiscard]] std::optional<double> seconds_left(double share, double seconds) const;

 private:
  /// Where the run was: at the last mark, and at the one before.
  struct Mark {
    double share = 0;
    double seconds = 0;
  };
  Mark mark_, earlier_mark_;
};

}  // namespace knitmech::run
