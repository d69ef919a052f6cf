#pragma once

#include "beam_case.h"

namespace knitmech::test {

inline constexpr double kPulledLength = 10.0;  ///< [mm]

/// A straight yarn of 0.12 mm along y in ten elements, held at one end and pulled at the other.
inline model::Model pulled_yarn(double axial, double strain, double speed, double ramp) {
  model::Model model =
      yarns_through({straight({0, 0, 0}, {0, kPulledLength, 0}, 10)}, section(axial, 6, 0.017, 0.012, 1e-11, 0.12));
  model.node_sets[model::kBottomFeet] = {0};
  model.node_sets[model::kTopHeads] = {10};
  model.contact_stiffness = 16;
  model.friction = 0.1;
  model.test.gauge_length = kPulledLength;
  model.test.strain = strain;
  model.test.speed = speed;
  model.test.ramp = ramp;
  return model;
}

}  // namespace knitmech::test
