#pragma once

#include <vector>

#include "picture/camera.h"
#include "picture/colour.h"
#include "picture/sampling.h"
#include "picture/tube_scene.h"

namespace knitmech::picture {

/// Two lamps that stand still beside the viewer: a large key lamp at the upper left, which throws soft shadows, and a
/// weak fill lamp at the right; and an even ambient light that yarn nearby takes away.
class Lighting {
 public:
  explicit Lighting(const ViewAxes& axes);

  /// Light that a point of a yarn sends to the viewer. One random ray goes to the key lamp and one into the ambient
  /// light; the mean over many calls is free of grain.
  [[nodiscard]] Colour of_yarn(const TubeScene& scene, const TubeHit& hit, const Colour& yarn_colour,
                               Randomness& random) const;

  /// Share of the light that reaches a point of the backdrop, 0 to 1. Its rays go to fixed places spread over the key
  /// lamp, so that the shadow has no grain.
  [[nodiscard]] double on_backdrop(const TubeScene& scene, const Eigen::Vector3d& point) const;

 private:
  Eigen::Vector3d towards_viewer_;
  Eigen::Vector3d key_;
  Eigen::Vector3d fill_;
  std::vector<Eigen::Vector3d> towards_key_;  ///< unit vectors to places spread over the key lamp
};

}  // namespace knitmech::picture
