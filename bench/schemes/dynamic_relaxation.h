#pragma once

#include <string>

#include "model/model.h"
#include "schemes/scheme.h"

namespace knitmech::bench {

/// How motion is taken from the fabric.
enum class Calming {
  kinetic,  ///< all velocities are set to zero whenever the kinetic energy has had a peak (Cundall 1976)
  viscous   ///< mass damping at the critical value of the motion that there is (Papadrakakis 1981, Underwood 1983)
};

struct Relaxation {
  std::string name;
  double increment = 0;  ///< of strain [-]
  Calming calming = Calming::kinetic;
  double tolerance = 0;  ///< residual over grip force [-], see StaticFabric::is_at_rest()
  bool selective_mass = false;
};

/// Dynamic relaxation: in increments of strain the nodes are moved evenly along with the grip, which then stands still
/// until explicit steps with damping have brought the fabric to rest. Friction goes along with the motion of the steps.
[[nodiscard]] SchemeResult relax(const model::Model& model, const Relaxation& scheme);

}  // namespace knitmech::bench
