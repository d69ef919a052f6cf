#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "base/thread_team.h"
#include "base/vectorise.h"

namespace knitmech::base {

/// Entries of long arrays (nodes, elements) that are worked on together [-].
///
/// Blocks are the same for any number of threads, and what is summed up is summed up within each block and then over
/// the blocks in their order: therefore results are the same to the last bit for any number of threads. More: less to
/// do between the blocks, until what belongs to one no longer fits into the first cache, and less even shares for the
/// threads where the arrays are short. A change changes sums within rounding.
inline constexpr std::size_t kBlock = 128;

constexpr std::size_t n_blocks(std::size_t n) {
  return (n + kBlock - 1) / kBlock;
}

/// Calls work(block, begin, end) for every block of 0 to n, on the threads of a team.
template <class Work>
void for_blocks(const ThreadTeam& team, std::size_t n, const Work& work) {
  team.for_ranges(n, kBlock, [&](std::size_t from, std::size_t to) {
    for (std::size_t begin = from; begin < to; begin += kBlock)
      work(begin / kBlock, begin, std::min(begin + kBlock, to));
  });
}

/// value(begin, end) of every block of 0 to n.
template <class Value>
[[nodiscard]] std::vector<double> values_of_blocks(const ThreadTeam& team, std::size_t n, const Value& value) {
  std::vector<double> values(n_blocks(n));
  for_blocks(team, n,
             [&](std::size_t block, std::size_t begin, std::size_t end) { values[block] = value(begin, end); });
  return values;
}

/// The sum of value(begin, end) over all blocks of 0 to n.
template <class Value>
[[nodiscard]] double sum_over_blocks(const ThreadTeam& team, std::size_t n, const Value& value) {
  double sum = 0;
  for (const double of_block : values_of_blocks(team, n, value)) sum += of_block;
  return sum;
}

/// The sum of values in an order that vectorises and is the same on every processor.
KNITMECH_INLINE double sum_in_lanes(const double* values, std::size_t n) {
  constexpr std::size_t kLanes = 8;
  std::array<double, kLanes> lanes{};
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) lanes[lane] += values[i + lane];
  }
  double sum = 0;
  for (; i < n; ++i) sum += values[i];
  for (const double of_lane : lanes) sum += of_lane;
  return sum;
}

}  // namespace knitmech::base
