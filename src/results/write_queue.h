#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace knitmech::results {

/// Does jobs one after the other on a thread of its own, so that files are written beside the run.
///
/// No more than kMostPendingWrites jobs are pending; whoever adds another waits, so that a slow disk slows the run down
/// instead of filling the memory. When a job has thrown, the jobs behind it are dropped, and its exception is thrown by
/// the next call of a member, and by every one after that.
class WriteQueue {
 public:
  WriteQueue();
  /// Does what is pending. An exception that nobody has asked for is lost; finish() asks.
  ~WriteQueue();
  WriteQueue(const WriteQueue&) = delete;
  WriteQueue& operator=(const WriteQueue&) = delete;
  WriteQueue(WriteQueue&&) = delete;
  WriteQueue& operator=(WriteQueue&&) = delete;

  void add(std::function<void()> job);
  /// Waits until all that was added before is done, on any thread.
  void finish();
  /// Throws what a job has thrown, if one has; never waits for a job.
  void check();

 private:
  void work();
  void rethrow() const;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;  ///< pending, the one that is being done first
  std::size_t n_added_ = 0, n_done_ = 0;
  std::exception_ptr error_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace knitmech::results
