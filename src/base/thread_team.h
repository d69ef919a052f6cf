#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

namespace knitmech::base {

/// A fixed team of threads for work that comes in short pieces, tens of thousands of times a second.
///
/// To share out a piece of work and to wait for its end costs about a microsecond while one piece follows the other:
/// the threads stay awake between them, for a moment. After about a millisecond without work they sleep and take no
/// processor time. The calling thread is one of the team. A team of one has no threads of its own and calls the work
/// as a function is called.
///
/// Nobody waits for a thread that has not begun: the others do its part. So the work is done in any case where there
/// are more threads than processors, or where a processor is busy with something else.
///
/// Work is given by one thread at a time, and never from within a part.
class ThreadTeam {
 public:
  /// \param size threads, with the calling one; at least 1
  explicit ThreadTeam(std::size_t size);
  ~ThreadTeam();
  ThreadTeam(ThreadTeam&&) noexcept;
  ThreadTeam& operator=(ThreadTeam&&) noexcept;
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  [[nodiscard]] std::size_t size() const { return size_; }

  /// Calls work(part) once for every part from 0 to size() - 1, each on any thread of the team, and the same part most
  /// often on the same one, whose cache may still hold its data. Returns when all have returned.
  ///
  /// If parts throw, the exception of the lowest of them is thrown here, after all have ended.
  template <class Work>
  void run(const Work& work) const {
    if (!crew_) {
      work(std::size_t{0});
      return;
    }
    run_parts([](const void* what, std::size_t part) { (*static_cast<const Work*>(what))(part); }, &work);
  }

  struct Range {
    std::size_t begin, end;
  };
  /// What a part has of 0 to n; may be empty. Ranges begin at multiples of `grain`.
  [[nodiscard]] Range range_of(std::size_t part, std::size_t n, std::size_t grain) const {
    const std::size_t n_grains = (n + grain - 1) / grain;
    return {std::min(n, grain * (n_grains * part / size_)), std::min(n, grain * (n_grains * (part + 1) / size_))};
  }

  /// Calls work(begin, end) for the ranges of all parts that are not empty.
  template <class Work>
  void for_ranges(std::size_t n, std::size_t grain, const Work& work) const {
    run([&](std::size_t part) {
      const Range range = range_of(part, n, grain);
      if (range.begin < range.end) work(range.begin, range.end);
    });
  }

 private:
  using Part = void (*)(const void* work, std::size_t part);
  void run_parts(Part call, const void* work) const;

  class Crew;
  std::size_t size_;
  std::unique_ptr<Crew> crew_;  ///< none in a team of one
};

}  // namespace knitmech::base
