#include "base/blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace knitmech::base {
namespace {

/// Numbers of very different size, so that a sum depends on its order.
std::vector<double> numbers(std::size_t n) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-8, 8);
  std::vector<double> numbers(n);
  for (double& number : numbers) number = std::pow(10.0, exponent(random));
  return numbers;
}

double sum_of(const std::vector<double>& numbers, std::size_t threads) {
  return sum_over_blocks(ThreadTeam(threads), numbers.size(), [&](std::size_t begin, std::size_t end) {
    return sum_in_lanes(&numbers[begin], end - begin);
  });
}

TEST(Blocks, GivenAnyNumberOfThreads_ThenASumIsTheSameToTheLastBit) {
  const std::vector<double> values = numbers(20 * kBlock + 57);
  const double alone = sum_of(values, 1);
  for (const std::size_t threads : {2U, 3U, 7U, 24U})
    EXPECT_EQ(sum_of(values, threads), alone) << threads << " threads";
}

TEST(Blocks, GivenNumbers_ThenTheSumIsThatInTheirOrderWithinRounding) {
  for (const std::size_t n : {0UL, 1UL, 7UL, 8UL, 9UL, kBlock, kBlock + 1, 5 * kBlock - 1}) {
    const std::vector<double> values = numbers(n);
    const auto expected = static_cast<double>(std::accumulate(values.begin(), values.end(), 0.0L));
    EXPECT_NEAR(sum_of(values, 2), expected, 1e-14 * expected) << n;
  }
}

TEST(Blocks, GivenABlock_ThenItsNumberAndItsEntriesAreWhatEveryThreadCounts) {
  const ThreadTeam team(3);
  const std::size_t n = 10 * kBlock + 5;
  std::vector<std::size_t> of_entry(n);
  std::vector<int> calls(n_blocks(n), 0);
  for_blocks(team, n, [&](std::size_t block, std::size_t begin, std::size_t end) {
    ++calls[block];
    for (std::size_t i = begin; i < end; ++i) of_entry[i] = block;
  });
  EXPECT_EQ(calls, std::vector<int>(11, 1));
  for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(of_entry[i], i / kBlock) << i;
}

}  // namespace
}  // namespace knitmech::base
