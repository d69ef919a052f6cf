#include "yarn/fineness.h"

#include <gtest/gtest.h>

#include <numbers>

#include "base/errors.h"

namespace knitmech::yarn {
namespace {

// Reference: 1 m of a 0.12 mm monofilament of 1140 kg/m^3 has pi/4 0.12^2 mm^2 * 1 m * 1.14 g/cm^3 = 0.0128931 g, which
// is 12.8931 tex = 12.8931e-12 t/mm.
constexpr double kLinearDensity = 1.14e-9 * std::numbers::pi / 4 * 0.12 * 0.12;

TEST(Fineness, FollowsFromTwoOfItsThreeValues) {
  EXPECT_NEAR(kLinearDensity, 12.8931e-12, 1e-16);
  EXPECT_NEAR(*completed({.diameter = 0.12, .density = 1.14e-9}).linear_density, kLinearDensity, 1e-25);
  EXPECT_NEAR(*completed({.diameter = 0.12, .linear_density = kLinearDensity}).density, 1.14e-9, 1e-22);
  EXPECT_NEAR(*completed({.linear_density = kLinearDensity, .density = 1.14e-9}).diameter, 0.12, 1e-14);
}

TEST(Fineness, StaysUnknownWithLessThanTwo) {
  const Fineness alone = completed({.diameter = 0.12});
  EXPECT_FALSE(alone.density || alone.linear_density);
  EXPECT_FALSE(completed({}).diameter);
}

TEST(Fineness, ThatContradictsItselfIsRefused) {
  EXPECT_NO_THROW((void)completed({.diameter = 0.12, .linear_density = 12.9e-12, .density = 1.14e-9}));
  EXPECT_THROW((void)completed({.diameter = 0.12, .linear_density = 13.1e-12, .density = 1.14e-9}), InputError);
  EXPECT_THROW((void)completed({.diameter = -0.12}), InputError);
  EXPECT_THROW((void)completed({.linear_density = 0.0}), InputError);
}

}  // namespace
}  // namespace knitmech::yarn
