#include "picture/shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "picture/constants.h"

namespace knitmech::picture {
namespace {

using Eigen::Vector3d;

// Brightness of the lamps and of the ambient light, together about 1 on a surface that faces the viewer.
constexpr double kKey = 0.78;
constexpr double kFill = 0.20;
constexpr double kAmbient = 0.36;
constexpr double kKeySize = 0.13;  // tangent of half the angle of the key lamp
// A yarn's gloss: share of the key lamp that is mirrored, and how narrow the highlight is.
constexpr double kGloss = 0.34;
constexpr double kGlossExponent = 38;

constexpr double kBackdropShadow = 0.42;  // share of the backdrop's light that comes from the key lamp

}  // namespace

Lighting::Lighting(const ViewAxes& axes)
    : towards_viewer_(axes.towards_viewer),
      key_((-0.50 * axes.right + 0.62 * axes.up + 0.80 * axes.towards_viewer).normalized()),
      fill_((0.85 * axes.right - 0.15 * axes.up + 0.55 * axes.towards_viewer).normalized()) {
  // Vogel's spiral, like the seeds of a sunflower: every place stands for the same area of the lamp.
  for (int i = 0; i < kShadowRays; ++i) {
    towards_key_.push_back(towards_lamp(key_, kKeySize, (i + 0.5) / kShadowRays, i / (1 + std::numbers::phi)));
  }
}

Colour Lighting::of_yarn(const TubeScene& scene, const TubeHit& hit, const Colour& yarn_colour,
                         Randomness& random) const {
  const double radius = scene.pieces()[static_cast<std::size_t>(hit.piece)].radius;
  const Vector3d origin = hit.point + (0.05 * radius) * hit.normal;
  const Vector3d to_lamp = towards_lamp(key_, kKeySize, random.next(), random.next());
  const Vector3d to_sky = away_from_surface(hit.normal, random.next(), random.next());
  double diffuse = kFill * std::max(0.0, hit.normal.dot(fill_));
  double gloss = 0;
  const double facing = hit.normal.dot(to_lamp);
  if (facing > 0 && !scene.is_blocked(origin, to_lamp, std::numeric_limits<double>::infinity())) {
    diffuse += kKey * facing;
    const double mirrored = std::max(0.0, hit.normal.dot((to_lamp + towards_viewer_).normalized()));
    gloss = kGloss * std::pow(mirrored, kGlossExponent);
  }
  if (!scene.is_blocked(origin, to_sky, kAmbientReach * 2 * radius)) {
    diffuse += kAmbient;
  }
  return static_cast<float>(diffuse) * yarn_colour + Colour::Constant(static_cast<float>(gloss));
}

double Lighting::on_backdrop(const TubeScene& scene, const Vector3d& point) const {
  const auto blocked = std::count_if(towards_key_.begin(), towards_key_.end(), [&](const Vector3d& direction) {
    return scene.is_blocked(point, direction, std::numeric_limits<double>::infinity());
  });
  return 1 - kBackdropShadow * static_cast<double>(blocked) / static_cast<double>(towards_key_.size());
}

}  // namespace knitmech::picture
