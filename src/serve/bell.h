#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace knitmech::serve {

/// Wakes those who wait for something to change.
class Bell {
 public:
  using Clock = std::chrono::steady_clock;

  void ring() {
    {
      const std::lock_guard lock(mutex_);
      ++n_rings_;
    }
    rung_.notify_all();
  }

  /// How often it has rung.
  [[nodiscard]] std::uint64_t n_rings() const {
    const std::lock_guard lock(mutex_);
    return n_rings_;
  }

  /// Waits until it has rung more often than that, but not longer than until an instant.
  void wait(std::uint64_t n_rings, Clock::time_point until) {
    std::unique_lock lock(mutex_);
    rung_.wait_until(lock, until, [&] { return n_rings_ > n_rings; });
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable rung_;
  std::uint64_t n_rings_ = 0;
};

}  // namespace knitmech::serve
