#pragma once

#include "base/vector3.h"

namespace knitmech::contact {

/// What a contact remembers of the steps before.
struct SlipMemory {
  Vector3 normal{};  ///< unit vector, first to second yarn; zero for a contact that is new
  Vector3
      elastic_slip{};  ///< stretch of the stick: elastic slip of the second yarn on the first [mm], across the normal
  double slid = 0;     ///< length of the path slid since the contact began [mm]
  bool slips = false;  ///< the Coulomb limit was reached in the last step
};

/// One step of friction at a contact.
struct FrictionStep {
  Vector3 force;  ///< on the second yarn [N]; the first gets the opposite
  double loss;    ///< dissipated in this step [mJ]
};

/// The stretch of a stick, turned with the contact: its part along the new normal is removed, its length kept.
KNITMECH_INLINE Vector3 turned_into_plane(Vector3 slip, Vector3 normal) {
  const Vector3 flat = slip - dot(slip, normal) * normal;
  const double before = dot(slip, slip);
  const double after = dot(flat, flat);
  return after > 0 ? std::sqrt(before / after) * flat : flat;
}

/// Coulomb friction with an elastic stick (return mapping, Simo and Laursen 1992, doi:10.1016/0045-7949(92)90540-G):
/// the slip since the last step stretches the stick; if its force would exceed mu N, the rest is slid off and
/// dissipated.
///
/// A stick that is cut down because the normal force falls gives its energy up, too.
/// \param memory of the contact; brought up to date
/// \param normal unit vector, first to second yarn
/// \param motion motion of the second yarn against the first since the last step [mm], at the contact
/// \param limit mu N [N]
/// \param stiffness of the stick [N/mm]
KNITMECH_INLINE FrictionStep friction_step(SlipMemory& memory, Vector3 normal, Vector3 motion, double limit,
                                           double stiffness) {
  const Vector3 before = turned_into_plane(memory.elastic_slip, normal);
  const Vector3 stretched = before + motion - dot(motion, normal) * normal;
  const double squared = dot(stretched, stretched);
  const bool slips = stiffness * stiffness * squared > limit * limit;
  double loss = 0;
  Vector3 slip = stretched;
  if (slips) {
    const double size = std::sqrt(squared);
    const double kept = limit / (stiffness * size);
    slip = kept * stretched;
    const double cut = stiffness * std::sqrt(dot(before, before)) - limit;
    loss = limit * (1 - kept) * size + (cut > 0 ? 0.5 * cut * cut / stiffness : 0);
    memory.slid += (1 - kept) * size;
  }
  memory.normal = normal;
  memory.elastic_slip = slip;
  memory.slips = slips;
  return {-stiffness * slip, loss};
}

}  // namespace knitmech::contact
