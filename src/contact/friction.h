#pragma once

#include <cstdint>
#include <vector>

#include "base/vector3.h"
#include "contact/contact_points.h"

namespace knitmech::contact {

/// What a contact point remembers of the step before.
struct SlipMemory {
  std::uint64_t key = 0;
  Vector3 normal{};            ///< unit vector, first to second yarn
  Vector3 elastic_slip{};      ///< elastic part of the slip of the second yarn on the first [mm], across the normal
  double stick_stiffness = 0;  ///< [N/mm], for the energy stored in the stick
};

/// One step of friction at a contact point.
struct FrictionStep {
  SlipMemory memory;
  Vector3 force;    ///< on the second yarn [N]; the first gets the opposite
  double loss = 0;  ///< dissipated in this step [mJ]
  bool slips = false;
};

/// Coulomb friction with an elastic stick (return mapping, Simo and Laursen 1992, doi:10.1016/0045-7949(92)90540-G):
/// the slip since the last step stretches the stick; if its force would exceed mu N, the rest is slid off and
/// dissipated.
///
/// The stick of the step before is turned with the contact: its part along the new normal is removed, its length kept.
/// \param before memory of this contact point, or of the place that it moved on from; none for a new contact
/// \param motion motion of the second yarn against the first since the last step [mm], at the contact point
/// \param limit mu N [N]
[[nodiscard]] FrictionStep friction_step(const ContactPoint& point, const SlipMemory* before, Vector3 motion,
                                         double limit);

/// Memory of the same contact point in the step before; nullptr if there was none.
/// \param memories by ascending key
[[nodiscard]] const SlipMemory* recall(const std::vector<SlipMemory>& memories, const ContactPoint& point);

/// Memory for a contact point that was not there a step before: that of the same place on an adjacent piece of either
/// yarn, if the contact slid on from it and is not found there any more; else any of the same or an adjacent pair,
/// whose overlap was counted otherwise a step before. It must have pressed in nearly the same direction. nullptr if
/// there is none. \param memories by ascending key   \param points all contact points of this step, by ascending key
[[nodiscard]] const SlipMemory* recall_moved(const std::vector<SlipMemory>& memories,
                                             const std::vector<ContactPoint>& points, const ContactPoint& point);

/// Energy stored in the elastic stick [mJ].
inline double stick_energy(const SlipMemory& memory) {
  return 0.5 * memory.stick_stiffness * dot(memory.elastic_slip, memory.elastic_slip);
}

}  // namespace knitmech::contact
