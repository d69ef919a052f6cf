#include "picture/colour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace knitmech::picture {
namespace {

/// CIE lightness L*, 0 to 100, of a colour in linear light; another measure than the one the map is built on.
double cie_lightness(const Colour& colour) {
  const double luminance = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
  return luminance > 0.008856 ? 116 * std::cbrt(luminance) - 16 : 903.3 * luminance;
}

TEST(ColourMap, GetsLighterInEqualSteps) {
  const double total = cie_lightness(map_colour(1)) - cie_lightness(map_colour(0));
  EXPECT_GT(total, 50);
  constexpr int kSteps = 20;
  for (int i = 0; i < kSteps; ++i) {
    const double step = cie_lightness(map_colour((i + 1.0) / kSteps)) - cie_lightness(map_colour(1.0 * i / kSteps));
    EXPECT_GT(step, 0.6 * total / kSteps) << i;
    EXPECT_LT(step, 1.4 * total / kSteps) << i;
  }
}

TEST(ColourMap, StaysApartForReadersWhoSeeNoRedOrNoGreen) {
  // Without the red-green difference only lightness and the yellow-blue difference are left; along the map the latter
  // grows too, from blue to yellow.
  const auto yellow_blue = [](const Colour& c) { return 0.5 * (c[0] + c[1]) - c[2]; };
  EXPECT_LT(yellow_blue(map_colour(0)), -0.1F);
  EXPECT_GT(yellow_blue(map_colour(1)), 0.5F);
}

TEST(ColourMap, CutsOffValuesOutsideItsRange) {
  EXPECT_EQ(map_colour(-1), map_colour(0));
  EXPECT_EQ(map_colour(2), map_colour(1));
  EXPECT_EQ(map_colour(std::numeric_limits<double>::quiet_NaN()), map_colour(0));
}

TEST(Colour, EverySrgbByteSurvivesTheWayThroughLinearLight) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    const Colour colour = from_srgb((byte << 16U) | ((255U - byte) << 8U) | 7U);
    EXPECT_EQ(to_srgb_byte(colour[0]), byte);
    EXPECT_EQ(to_srgb_byte(colour[1]), 255U - byte);
    EXPECT_EQ(to_srgb_byte(colour[2]), 7U);
  }
  EXPECT_EQ(to_srgb_byte(-1), 0);
  EXPECT_EQ(to_srgb_byte(2), 255);
}

TEST(Colour, HalfTheLightIsTheByte188) {
  // IEC 61966-2-1: 255 (1.055 0.5^(1/2.4) - 0.055) = 187.5
  EXPECT_NEAR(to_srgb_byte(0.5F), 187.5, 0.6);
}

}  // namespace
}  // namespace knitmech::picture
