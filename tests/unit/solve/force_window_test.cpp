#include "solve/force_window.h"

#include <gtest/gtest.h>

#include <cmath>

namespace knitmech::solve {
namespace {

TEST(ForceWindow, GivenAForceLinearInTheDisplacement_ThenItIsReadWithoutLag) {
  ForceWindow window;
  double displacement = 3.0;
  for (int i = 0; i < 50; ++i) {
    const double h = 1e-4 * (1 + i % 3);
    displacement += 0.2 * h;
    window.add(displacement, {5 + 2 * displacement, -1 - 7 * displacement}, h);
  }
  EXPECT_NEAR(window.at(displacement).top, 5 + 2 * displacement, 1e-9);
  EXPECT_NEAR(window.at(displacement).bottom, -1 - 7 * displacement, 1e-9);
}

TEST(ForceWindow, GivenFastVibration_ThenLittleOfItIsLeft) {
  ForceWindow window;
  for (int i = 1; i <= 1000; ++i) window.add(1e-3 * i, {4 + std::sin(0.9 * i), 0}, 1e-4);
  EXPECT_NEAR(window.at(1.0).top, 4, 0.01);
}

TEST(ForceWindow, GivenAGripAtRest_ThenTheForcesAreTheMeans) {
  ForceWindow window;
  EXPECT_TRUE(window.empty());
  window.add(0.7, {1, 10}, 1e-4);
  window.add(0.7, {4, 40}, 2e-4);
  EXPECT_FALSE(window.empty());
  EXPECT_NEAR(window.at(0.7).top, 3, 1e-12);
  EXPECT_NEAR(window.at(0.7).bottom, 30, 1e-12);
}

TEST(ForceWindow, GivenOneStep_ThenItsForcesAreRead) {
  ForceWindow window;
  window.add(0.1, {2, 3}, 1e-4);
  EXPECT_EQ(window.at(0.11).top, 2);
  EXPECT_EQ(window.at(0.11).bottom, 3);
}

}  // namespace
}  // namespace knitmech::solve
