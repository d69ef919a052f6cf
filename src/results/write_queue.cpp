#include "results/write_queue.h"

#include <utility>

#include "results/constants.h"

namespace knitmech::results {

WriteQueue::WriteQueue() : thread_([this] { work(); }) {}

WriteQueue::~WriteQueue() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void WriteQueue::rethrow() const {
  if (error_) std::rethrow_exception(error_);
}

void WriteQueue::add(std::function<void()> job) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return error_ || jobs_.size() < kMostPendingWrites; });
  rethrow();
  jobs_.push_back(std::move(job));
  ++n_added_;
  changed_.notify_all();
}

void WriteQueue::finish() {
  std::unique_lock lock(mutex_);
  const std::size_t wanted = n_added_;
  changed_.wait(lock, [&] { return error_ || n_done_ >= wanted; });
  rethrow();
}

void WriteQueue::check() {
  const std::lock_guard lock(mutex_);
  rethrow();
}

/// A job stays in the list while it is done, and is destroyed without the lock.
void WriteQueue::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return closing_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    std::function<void()> job = std::move(jobs_.front());
    lock.unlock();
    std::exception_ptr error;
    try {
      job();
    } catch (...) {
      error = std::current_exception();
    }
    job = nullptr;
    lock.lock();
    jobs_.pop_front();
    ++n_done_;
    if (error) {
      error_ = error;
      jobs_.clear();
    }
    changed_.notify_all();
  }
}

}  // namespace knitmech::results
