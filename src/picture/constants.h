#pragma once

namespace knitmech::picture {

/// Side of the grid of rays in a pixel that yarn may cover [-]; usual 4, so 16 rays. More makes edges smoother and the
/// picture slower, with the square.
inline constexpr int kRaysPerPixelSide = 4;

/// Grid on which the shadow on the backdrop is computed, before it is interpolated [px]; usual 3.
inline constexpr int kShadowGrid = 3;

/// Rays to the lamp at each point of that grid [-]; usual 40. Fewer let single copies of a yarn's shadow show.
inline constexpr int kShadowRays = 40;

/// Distance over which yarn darkens the ambient light at another yarn, in yarn diameters [-]; usual 6.
inline constexpr double kAmbientReach = 6;

/// Distance of the backdrop behind the rearmost yarn, in yarn diameters [-]; usual 4. Closer makes shadows sharper.
inline constexpr double kBackdropDistance = 4;

}  // namespace knitmech::picture
