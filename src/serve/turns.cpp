#include "serve/turns.h"

namespace knitmech::serve {

Turns::Ticket Turns::line_up() {
  const std::lock_guard lock(mutex_);
  line_.insert(next_);
  return next_++;
}

bool Turns::take(Ticket ticket, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, stop, [&] { return is_closed_ || (n_free_ > 0 && *line_.begin() == ticket); });
  // Who is asked to stop leaves a turn that comes free at the same time to the next.
  const bool has_turn = !is_closed_ && !stop.stop_requested();
  line_.erase(ticket);
  if (has_turn) {
    --n_free_;
    ++n_taken_;
  }
  lock.unlock();
  changed_.notify_all();
  return has_turn;
}

void Turns::give_back() {
  {
    const std::lock_guard lock(mutex_);
    ++n_free_;
    --n_taken_;
  }
  changed_.notify_all();
}

void Turns::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  changed_.notify_all();
}

bool Turns::is_alone() const {
  const std::lock_guard lock(mutex_);
  return n_taken_ == 1 && line_.empty();
}

}  // namespace knitmech::serve
