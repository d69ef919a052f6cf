#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>

#include "results/checkpoint_file.h"

namespace knitmech::results {

/// Writes the checkpoints of a run on a thread of its own, one after the other.
class CheckpointWriter {
 public:
  /// \param interval [s] of real time between two checkpoints; 0: none is ever due
  CheckpointWriter(std::filesystem::path dir, double interval);

  /// True once the interval is over, unless the one before is still being written.
  [[nodiscard]] bool is_due() const;

  /// Begins to write one, as soon as the one before is done.
  /// \param first what has to be done before it counts, on the same thread; throws FileError
  /// @throws FileError of the one before
  void write(Checkpoint checkpoint, std::function<void()> first);

  /// Waits until all is written. @throws FileError
  void wait();

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path dir_;
  double interval_;
  Clock::time_point last_ = Clock::now();
  std::future<void> writing_;
};

}  // namespace knitmech::results
