#pragma once

#include <functional>

#include "picture/camera.h"
#include "picture/image.h"
#include "picture/tube_scene.h"

namespace knitmech::picture {

/// What the ray tracer is to draw.
struct Drawing {
  const TubeScene& scene;
  const Camera& camera;
  Extent extent;  ///< of the scene along the camera's axes
  Area area;      ///< of the picture that is drawn on
  bool has_shadow_on_backdrop = true;
  std::function<Colour(const TubeHit&)> yarn_colour;  ///< called from several threads at once
};

/// Draws yarns over the colour that the image already has, and their shadow on it. The result does not depend on the
/// number of threads (at least 1).
void trace(Image& image, const Drawing& drawing, int threads);

}  // namespace knitmech::picture
