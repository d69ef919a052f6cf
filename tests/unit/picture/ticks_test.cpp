#include "picture/ticks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace knitmech::picture {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

TEST(Ticks, AreRoundAndEncloseTheRange) {
  const Ticks ticks = nice_ticks(0, 0.22, 5);
  EXPECT_THAT(ticks.values, Pointwise(DoubleNear(1e-12), {0.0, 0.05, 0.10, 0.15, 0.20, 0.25}));
  EXPECT_THAT(ticks.labels, ElementsAre("0.00", "0.05", "0.10", "0.15", "0.20", "0.25"));
}

TEST(Ticks, ReachNoFurtherThanARangeThatEndsOnATick) {
  EXPECT_THAT(nice_ticks(0, 1000, 5).labels, ElementsAre("0", "200", "400", "600", "800", "1000"));
  EXPECT_THAT(nice_ticks(-0.3, 0.3, 6).labels, ElementsAre("-0.3", "-0.2", "-0.1", "0.0", "0.1", "0.2", "0.3"));
}

TEST(Ticks, EncloseAnyRangeInStepsOfOneTwoOrFive) {
  for (const double lowest : {-3e7, -12.3, -1e-9, 0.0, 1e-12, 4.7, 999.0}) {
    for (const double width : {1e-8, 0.013, 1.0, 7.7, 1234.5, 6e8}) {
      const Ticks ticks = nice_ticks(lowest, lowest + width, 6);
      const double step = ticks.values[1] - ticks.values[0];
      EXPECT_LE(ticks.first(), lowest + 1e-6 * step);
      EXPECT_GE(ticks.last(), lowest + width - 1e-6 * step);
      EXPECT_LE(ticks.values.size(), 9U);
      const double exact_step = (ticks.last() - ticks.first()) / static_cast<double>(ticks.values.size() - 1);
      const double mantissa = exact_step / std::pow(10.0, std::floor(std::log10(exact_step * (1 + 1e-7))));
      EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 || std::abs(mantissa - 5) < 1e-6)
          << mantissa;
    }
  }
}

TEST(Ticks, ARangeWithoutWidthIsWidened) {
  for (const double value : {0.0, 3.0, -1e-7, 1e9}) {
    const Ticks ticks = nice_ticks(value, value, 5);
    EXPECT_LT(ticks.first(), value);
    EXPECT_GT(ticks.last(), value);
  }
  EXPECT_GT(nice_ticks(0, std::numeric_limits<double>::infinity(), 5).values.size(), 2U);
}

TEST(Ticks, OfALogarithmicAxisEncloseTheRange) {
  const auto between = [](double lowest, double highest) {
    return nice_log_ticks(std::log10(lowest), std::log10(highest));
  };
  // Given a range of less than three powers of ten, then one of more, then one that ends on ticks, and one of no width.
  EXPECT_THAT(between(0.03, 7).labels, ElementsAre("0.02", "0.05", "0.1", "0.2", "0.5", "1", "2", "5", "10"));
  EXPECT_THAT(between(3, 4e3).labels, ElementsAre("1", "10", "100", "1000", "10000"));
  EXPECT_THAT(between(2, 50).labels, ElementsAre("2", "5", "10", "20", "50"));
  EXPECT_THAT(between(5, 5).labels, ElementsAre("5", "10"));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(nice_log_ticks(infinity, -infinity).labels, ElementsAre("1", "2", "5", "10"));
  // Then values are the logarithms of what the labels say.
  EXPECT_THAT(between(2, 20).values, Pointwise(DoubleNear(1e-12), {std::log10(2), std::log10(5), 1.0, std::log10(20)}));
}

TEST(Ticks, RoundNumberBelowIsTheLargestOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(round_number_below(9.99), 5);
  EXPECT_DOUBLE_EQ(round_number_below(5), 5);
  EXPECT_DOUBLE_EQ(round_number_below(4.99), 2);
  EXPECT_DOUBLE_EQ(round_number_below(0.0199), 0.01);
  EXPECT_DOUBLE_EQ(round_number_below(1000), 1000);
}

}  // namespace
}  // namespace knitmech::picture
