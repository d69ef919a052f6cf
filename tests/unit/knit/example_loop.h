#pragma once

#include "knit/fabric.h"

namespace knitmech::knit {

/// The loop, yarn and fabric of the example examples/02-wale-tension, in mm.
inline constexpr double kExampleDiameter = 0.12;

inline LoopShape example_loop() {
  return {.height = 7.0,
          .width = 3.9,
          .head_flat = 0.2,
          .head_radius = 1.1,
          .foot_flat = 0.2,
          .foot_radius = 1.0,
          .out_of_plane = 0.02};
}

inline FabricLayout example_layout() {
  return {.loop = example_loop(),
          .wales = 9,
          .courses = 15,
          .course_spacing = 5.0,
          .structure = Structure::basic,
          .elements_per_erc = 10};
}

}  // namespace knitmech::knit
