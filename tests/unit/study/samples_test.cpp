#include "study/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace knitmech::study {
namespace {

TEST(LatinHypercube, GivenNSamplesWhenDrawnThenEachNthOfEachDimensionHasExactlyOne) {
  constexpr std::size_t kSamples = 17, kDimensions = 4;
  const Samples samples = latin_hypercube(kSamples, kDimensions, 3);
  ASSERT_EQ(samples.size(), kSamples);
  for (std::size_t dimension = 0; dimension < kDimensions; ++dimension) {
    std::set<int> parts;
    for (const auto& sample : samples) parts.insert(static_cast<int>(std::floor(sample[dimension] * kSamples)));
    EXPECT_EQ(parts.size(), kSamples);
    EXPECT_EQ(*parts.begin(), 0);
    EXPECT_EQ(*parts.rbegin(), static_cast<int>(kSamples) - 1);
  }
}

TEST(LatinHypercube, GivenTheSameSeedThenThePointsAreTheSameAndWithAnotherTheyAreNot) {
  EXPECT_EQ(latin_hypercube(8, 2, 5), latin_hypercube(8, 2, 5));
  EXPECT_NE(latin_hypercube(8, 2, 5), latin_hypercube(8, 2, 6));
}

// The first points of the sequence in one and two dimensions stand in every text on it.
TEST(Sobol, GivenTwoDimensionsThenTheFirstPointsAreThoseOfTheLiterature) {
  const Samples expected = {{0.5, 0.5}, {0.75, 0.25}, {0.25, 0.75}, {0.375, 0.375}, {0.875, 0.875}};
  EXPECT_EQ(sobol(5, 2), expected);
}

// With the origin, 2^k points have one in each 2^k-th part of each dimension.
TEST(Sobol, GivenAllButOneOfAPowerOfTwoThenEachPartButTheFirstHasOnePoint) {
  for (std::size_t dimension = 0; dimension < 6; ++dimension) {
    std::set<int> parts;
    for (const auto& sample : sobol(31, 6)) parts.insert(static_cast<int>(sample[dimension] * 32));
    EXPECT_EQ(parts.size(), 31U);
    EXPECT_FALSE(parts.contains(0));
  }
}

}  // namespace
}  // namespace knitmech::study
