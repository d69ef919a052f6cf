#pragma once

#include <algorithm>
#include <optional>

#include "contact/centreline.h"
#include "contact/contact_points.h"
#include "contact/friction_table.h"
#include "contact/motion.h"
#include "model/state.h"

namespace knitmech::contact {

/// What contact needs to know besides the yarns.
struct ContactLaw {
  double stiffness = 0;  ///< K of a crossing [N/mm]
  FrictionTable friction;
};

/// Everything that a step of contacts works with.
struct StepOfContacts {
  const YarnElements& elements;
  const Centreline& line;
  const ContactLaw& law;
  const Motion& motion;
  const model::State& state;
  double length;          ///< [s] since the step before; velocities times length are the motion since then
  double density_factor;  ///< see line_potential.h
};

/// What a step of contacts comes to.
struct ContactStep {
  double friction_loss = 0;               ///< [mJ]
  double largest_penetration = 0;         ///< [mm]
  std::optional<LostCrossing> lost = {};  ///< if a yarn went through another: the first found
  bool asks_for_look = false;             ///< an overlap has grown too long for a crossing

  /// Adds what comes after.
  void add(const ContactStep& next) {
    friction_loss += next.friction_loss;
    largest_penetration = std::max(largest_penetration, next.largest_penetration);
    if (!lost) lost = next.lost;
    asks_for_look = asks_for_look || next.asks_for_look;
  }
};

}  // namespace knitmech::contact
