#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace knitmech::bench {

/// Shortest mean time of one call [s], of five rounds of a tenth of a second or one call each.
template <class Work>
[[nodiscard]] double shortest_time(const Work& work) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRounds = 5;
  constexpr double kRound = 0.1;  // [s]
  work();                         // fetches what it works on
  double shortest = std::numeric_limits<double>::max();
  for (int round = 0; round < kRounds; ++round) {
    const auto start = Clock::now();
    double seconds = 0;
    long calls = 0;
    for (; seconds < kRound; ++calls) {
      work();
      seconds = std::chrono::duration<double>(Clock::now() - start).count();
    }
    shortest = std::min(shortest, seconds / static_cast<double>(calls));
  }
  return shortest;
}

}  // namespace knitmech::bench
