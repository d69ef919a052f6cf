#pragma once

namespace knitmech::app {

/// While one of these exists, Ctrl-C (SIGINT) and SIGTERM only raise a flag, so that a run can end cleanly. The second
/// signal of a kind ends the program at once, as usual.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  /// Whether one of the signals has come.
  [[nodiscard]] static bool requested();
};

}  // namespace knitmech::app
