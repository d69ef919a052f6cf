#include "run/time_left.h"

#include <gtest/gtest.h>

namespace knitmech::run {
namespace {

TEST(TimeLeft, GivenNothingDone_ThenNothingIsSaid) {
  const TimeLeft left(0.3);
  EXPECT_FALSE(left.seconds_left(0.3, 10).has_value());
}

TEST(TimeLeft, GivenASteadyPace_ThenItIsWhatTheRestTakesAtIt) {
  TimeLeft left(0);
  for (int percent = 1; percent <= 40; ++percent) left.update(0.01 * percent, 2 * percent);
  EXPECT_NEAR(left.seconds_left(0.4, 80).value(), 120, 1e-9);
}

TEST(TimeLeft, GivenARunThatGoesOnFromThreeTenths_ThenOnlyItsOwnPaceCounts) {
  TimeLeft left(0.3);
  left.update(0.31, 5);
  EXPECT_NEAR(left.seconds_left(0.31, 5).value(), 5 * 69, 1e-9);
}

TEST(TimeLeft, GivenAPaceThatChanges_ThenTheLatestCounts) {
  // Given 10 s for the first half, 100 s for the next tenth: the rest at 1000 s for the whole.
  TimeLeft left(0);
  for (int percent = 1; percent <= 50; ++percent) left.update(0.01 * percent, 0.2 * percent);
  for (int percent = 51; percent <= 60; ++percent) left.update(0.01 * percent, 10.0 * (percent - 50) + 10);
  EXPECT_NEAR(left.seconds_left(0.6, 110).value(), 400, 10);
}

}  // namespace
}  // namespace knitmech::run
