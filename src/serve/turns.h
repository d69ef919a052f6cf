#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>
#include <stop_token>

namespace knitmech::serve {

/// Lets at most some go at a time, and the others in the order in which they lined up.
class Turns {
 public:
  using Ticket = std::uint64_t;

  explicit Turns(int n_at_once) : n_free_(n_at_once) {}

  [[nodiscard]] Ticket line_up();

  /// Waits for one's turn. Returns false, and leaves the line, if it was asked to stop before, or after close().
  [[nodiscard]] bool take(Ticket ticket, const std::stop_token& stop);

  /// Ends the turn that take() has given.
  void give_back();

  /// From now on nobody gets a turn, and those who wait get none.
  void close();

  /// Whether one turn is taken and nobody waits.
  [[nodiscard]] bool is_alone() const;

 private:
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::set<Ticket> line_;
  Ticket next_ = 0;
  int n_free_, n_taken_ = 0;
  bool is_closed_ = false;
};

}  // namespace knitmech::serve
