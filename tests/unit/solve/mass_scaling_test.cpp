#include "solve/mass_scaling.h"

#include <gtest/gtest.h>

#include "../../support/beam_case.h"

namespace knitmech {
namespace {

model::Model yarn_with(double bending, double mass_per_length, double speed) {
  model::Model model = test::yarns_through({test::straight({0, 0, 0}, {8, 0, 0}, 2)},
                                           test::section(19, 6, bending, 0.012, mass_per_length));
  model.test.speed = speed;
  return model;
}

TEST(MassScaling, GivenHalfTheSpeed_ThenFourTimesTheMassIsAllowed) {
  const double fast = solve::automatic_mass_scaling(yarn_with(0.017, 1.3e-11, 5.0));
  EXPECT_GT(fast, 1.0);
  EXPECT_NEAR(solve::automatic_mass_scaling(yarn_with(0.017, 1.3e-11, 2.5)), 4 * fast, 1e-9 * fast);
}

TEST(MassScaling, GivenAStifferOrLighterYarn_ThenTheAllowedMassPerLengthFollowsTheBendingStiffness) {
  const double reference = solve::automatic_mass_scaling(yarn_with(0.017, 1.3e-11, 5.0));
  EXPECT_NEAR(solve::automatic_mass_scaling(yarn_with(0.034, 1.3e-11, 5.0)), 2 * reference, 1e-9 * reference);
  EXPECT_NEAR(solve::automatic_mass_scaling(yarn_with(0.017, 0.65e-11, 5.0)), 2 * reference, 1e-9 * reference);
}

TEST(MassScaling, GivenAnImpact_ThenMassesAreNeverScaledDown) {
  EXPECT_EQ(solve::automatic_mass_scaling(yarn_with(0.017, 1.3e-11, 1e6)), 1.0);
}

TEST(MassScaling, GivenAMassScalingInTheCaseOrAnImpact_ThenTheSpeedIsNotAdapted) {
  model::Case input;
  EXPECT_TRUE(solve::adapts_pace(input, 233));
  EXPECT_FALSE(solve::adapts_pace(input, 1));
  input.solver.mass_scaling = 233;
  EXPECT_FALSE(solve::adapts_pace(input, 233));
}

}  // namespace
}  // namespace knitmech
