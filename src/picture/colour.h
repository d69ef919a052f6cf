#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace knitmech::picture {

/// Red, green and blue in linear light, 0 to 1 (primaries of sRGB, IEC 61966-2-1).
using Colour = Eigen::Vector3f;

/// The colour written as 0xrrggbb in sRGB.
[[nodiscard]] Colour from_srgb(std::uint32_t rgb);

/// One channel as the byte of an sRGB picture; values outside 0 to 1 are cut off.
[[nodiscard]] std::uint8_t to_srgb_byte(float linear);

/// The colour of a value between 0 and 1 (cut off outside): indigo, blue, teal, green, yellow.
///
/// Its lightness in the Oklab colour space (B. Ottosson, "A perceptual color space for image processing", 2020) grows
/// linearly, so equal steps look equal, the order shows in grey print, and no pair of colours is lost to colour
/// blindness.
[[nodiscard]] Colour map_colour(double value);

}  // namespace knitmech::picture
