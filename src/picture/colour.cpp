#include "picture/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace knitmech::picture {
namespace {

float srgb_to_linear(float value) {
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

/// A colour in the polar form of Oklab without its lightness, at one value of the map.
struct HuePoint {
  double value;
  double chroma;
  double hue;  ///< [degrees]
};
constexpr std::array<HuePoint, 5> kHues{
    {{0.00, 0.150, 285}, {0.25, 0.115, 250}, {0.50, 0.100, 205}, {0.75, 0.140, 155}, {1.00, 0.165, 100}}};
constexpr double kDarkest = 0.40;   // Oklab lightness at 0
constexpr double kLightest = 0.88;  // Oklab lightness at 1

Colour from_oklab(double lightness, double a, double b) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  const Eigen::Vector3d rgb{4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  return rgb.cwiseMax(0.0).cwiseMin(1.0).cast<float>();
}

}  // namespace

Colour from_srgb(std::uint32_t rgb) {
  const auto channel = [rgb](unsigned shift) {
    return srgb_to_linear(static_cast<float>((rgb >> shift) & 255U) / 255.0F);
  };
  return {channel(16), channel(8), channel(0)};
}

std::uint8_t to_srgb_byte(float linear) {
  const float x = std::clamp(linear, 0.0F, 1.0F);
  const float value = x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1.0F / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(255.0F * value));
}

Colour map_colour(double value) {
  const double t = std::isnan(value) ? 0.0 : std::clamp(value, 0.0, 1.0);
  std::size_t above = 1;
  while (above + 1 < kHues.size() && t >= kHues[above].value) {
    ++above;
  }
  const HuePoint& low = kHues[above - 1];
  const HuePoint& high = kHues[above];
  const double share = (t - low.value) / (high.value - low.value);
  const double chroma = std::lerp(low.chroma, high.chroma, share);
  const double hue = std::lerp(low.hue, high.hue, share) * std::numbers::pi / 180;
  return from_oklab(std::lerp(kDarkest, kLightest, t), chroma * std::cos(hue), chroma * std::sin(hue));
}

}  // namespace knitmech::picture
