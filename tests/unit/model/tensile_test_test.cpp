#include <gtest/gtest.h>

#include "model/model.h"

namespace knitmech::model {
namespace {

/// 5 mm/s after a ramp of 0.5 s, on 77 mm of fabric.
TensileTest example() {
  TensileTest test;
  test.gauge_length = 77;
  test.strain = 0.22;
  test.speed = 5;
  test.ramp = 0.5;
  return test;
}

TEST(TensileTestMotion, SpeedGrowsLinearlyOverTheRampAndThenStays) {
  const TensileTest test = example();
  EXPECT_EQ(test.velocity(0), 0);
  EXPECT_NEAR(test.velocity(0.25), 2.5, 1e-15);
  EXPECT_EQ(test.velocity(0.5), 5);
  EXPECT_EQ(test.velocity(3), 5);
}

TEST(TensileTestMotion, DisplacementIsTheAreaUnderTheSpeed) {
  const TensileTest test = example();
  EXPECT_EQ(test.displacement(0), 0);
  EXPECT_NEAR(test.displacement(0.25), 0.5 * 0.25 * 2.5, 1e-15);
  EXPECT_NEAR(test.displacement(0.5), 0.5 * 0.5 * 5, 1e-15);
  EXPECT_NEAR(test.displacement(2.5), 1.25 + 2 * 5, 1e-14);
}

TEST(TensileTestMotion, NothingMovesBeforeTheStart) {
  EXPECT_EQ(example().displacement(-1), 0);
  EXPECT_EQ(example().velocity(-1), 0);
}

TEST(TensileTestMotion, TimeOfAStrainIsTheInverseOfItsDisplacement) {
  // Given strains within the ramp (up to 1.25 mm / 77 mm = 0.0162), at its end and after it,
  const TensileTest test = example();
  for (const double strain : {0.0, 1e-6, 0.01, 1.25 / 77, 0.022, 0.08, 0.22, 0.42}) {
    EXPECT_NEAR(test.displacement(test.time_at(strain)), strain * 77, 1e-13) << strain;
  }
  EXPECT_NEAR(test.time_at(0.22), (0.22 * 77 - 1.25) / 5 + 0.5, 1e-13);
}

TEST(TensileTestMotion, WithoutARampTheSpeedIsThereFromTheStart) {
  TensileTest test = example();
  test.ramp = 0;
  EXPECT_EQ(test.velocity(0), 5);
  EXPECT_EQ(test.displacement(0), 0);
  EXPECT_NEAR(test.displacement(2), 10, 1e-14);
  EXPECT_EQ(test.time_at(0), 0);
  EXPECT_NEAR(test.time_at(0.22), 0.22 * 77 / 5, 1e-14);
}

}  // namespace
}  // namespace knitmech::model
