#include "base/thread_team.h"

#include <atomic>
#include <cstdint>
#include <exception>
#include <thread>
#include <vector>

namespace knitmech::base {

namespace {

/// Looks that a waiting thread takes without a break, a few to twenty microseconds of them [-]. More: a late start of
/// the next piece of work is bridged faster, and a thread that could run in the place of this one waits longer.
constexpr int kLooks = 400;
/// Looks after these, each followed by letting another thread run, about a millisecond on an idle processor [-]. More:
/// less often a thread has to be woken up, which costs ten times as much, and more processor time goes in vain.
constexpr int kPoliteLooks = 2000;
/// Bytes that processors hand from one to the other at a time [-]; data of two threads closer than this slow them down.
constexpr std::size_t kCacheLine = 64;

/// Tells the processor that this is a loop that waits.
void rest() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// Whether `is_over` comes true while the thread is kept awake for it.
template <class Condition>
bool comes_soon(const Condition& is_over) {
  for (int look = 0; look < kLooks; ++look) {
    if (is_over()) return true;
    rest();
  }
  for (int look = 0; look < kPoliteLooks; ++look) {
    if (is_over()) return true;
    std::this_thread::yield();
  }
  return false;
}

bool is_open(std::uint32_t gate) {
  return gate % 2 == 1;
}

}  // namespace

/// Every piece of work is a round: the gate opens, whoever comes takes parts that nobody has taken, the caller too;
/// when there are no more, the gate closes, and the caller waits until all who are inside have left. A thread that
/// goes inside says so before it looks at the gate, and the caller closes the gate before it looks who is inside: so
/// either the thread sees the closed gate or the caller sees the thread.
class ThreadTeam::Crew {
 public:
  explicit Crew(std::size_t size) : seats_(size) {
    try {
      for (std::size_t seat = 1; seat < size; ++seat) threads_.emplace_back([this, seat] { serve(seat); });
    } catch (...) {
      send_home();
      throw;
    }
  }
  ~Crew() { send_home(); }
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  void run(Part call, const void* work) {
    call_ = call;
    work_ = work;
    const std::uint32_t round = gate_.load() + 1;
    gate_.store(round);
    gate_.notify_all();
    take_parts(0, round);
    gate_.store(round + 1);
    for (const Seat& seat : seats_) {
      while (!comes_soon([&] { return !seat.is_inside.load(); })) {
      }
    }
    if (has_failed_.load()) rethrow_first();
  }

 private:
  /// Of a thread, and of the part that it takes first.
  struct alignas(kCacheLine) Seat {
    std::atomic<std::uint32_t> taken_in = 0;  ///< round in which the part was last taken
    std::atomic<bool> is_inside = false;
    std::exception_ptr failure;  ///< of the part
  };

  void serve(std::size_t seat) {
    std::uint32_t last_round = 0;
    while (!is_over_.load()) {
      wait_for_round_after(last_round);
      seats_[seat].is_inside.store(true);
      const std::uint32_t gate = gate_.load();
      if (is_open(gate)) {
        take_parts(seat, gate);
        last_round = gate;
      }
      seats_[seat].is_inside.store(false);
    }
  }

  /// May return too early.
  void wait_for_round_after(std::uint32_t last_round) {
    const auto is_next = [&](std::uint32_t gate) { return is_open(gate) && gate != last_round; };
    if (comes_soon([&] { return is_next(gate_.load()) || is_over_.load(); })) return;
    const std::uint32_t gate = gate_.load();
    if (!is_next(gate) && !is_over_.load()) gate_.wait(gate);
  }

  void take_parts(std::size_t first, std::uint32_t round) {
    for (std::size_t i = 0; i < seats_.size(); ++i) {
      const std::size_t part = first + i < seats_.size() ? first + i : first + i - seats_.size();
      std::atomic<std::uint32_t>& taken_in = seats_[part].taken_in;
      if (taken_in.load() != round && taken_in.exchange(round) != round) do_part(part);
    }
  }

  void do_part(std::size_t part) {
    try {
      call_(work_, part);
    } catch (...) {
      seats_[part].failure = std::current_exception();
      has_failed_.store(true);
    }
  }

  void rethrow_first() {
    has_failed_.store(false);
    std::exception_ptr first;
    for (Seat& seat : seats_) {
      if (!first) first = seat.failure;
      seat.failure = nullptr;
    }
    std::rethrow_exception(first);
  }

  void send_home() {
    is_over_.store(true);
    gate_.fetch_add(2);
    gate_.notify_all();
  }

  Part call_ = nullptr;
  const void* work_ = nullptr;
  std::vector<Seat> seats_;
  alignas(kCacheLine) std::atomic<std::uint32_t> gate_ = 0;  ///< odd: a round is open, which has this number
  alignas(kCacheLine) std::atomic<bool> has_failed_ = false;
  std::atomic<bool> is_over_ = false;
  std::vector<std::jthread> threads_;  ///< last, so that they end first
};

ThreadTeam::ThreadTeam(std::size_t size)
    : size_(std::max(size, std::size_t{1})), crew_(size_ > 1 ? std::make_unique<Crew>(size_) : nullptr) {}
ThreadTeam::~ThreadTeam() = default;
ThreadTeam::ThreadTeam(ThreadTeam&&) noexcept = default;
ThreadTeam& ThreadTeam::operator=(ThreadTeam&&) noexcept = default;

void ThreadTeam::run_parts(Part call, const void* work) const {
  crew_->run(call, work);
}

}  // namespace knitmech::base
