#pragma once

#include <cstdint>

#include "base/vector3.h"
#include "contact/friction.h"
#include "contact/yarn_elements.h"

namespace knitmech::contact {

/// One place where two yarns press on each other.
struct ContactPoint {
  YarnPlace first{}, second{};  ///< on yarns in ascending order of elements
  Vector3 normal{};             ///< unit vector from the first centreline to the second
  double penetration = 0;       ///< sum of the radii minus centreline distance [mm], > 0
  double load = 0;              ///< normal force [N]
  double tangent = 0;           ///< derivative of the load by the penetration [N/mm]
  double energy = 0;            ///< stored in the normal law [mJ]
  double stick_stiffness = 0;   ///< [N/mm]
  SlipMemory stick;

  [[nodiscard]] double stick_energy() const {
    return 0.5 * stick_stiffness * dot(stick.elastic_slip, stick.elastic_slip);
  }
  /// Friction force on the second yarn [N].
  [[nodiscard]] Vector3 friction_force() const { return -stick_stiffness * stick.elastic_slip; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(first, second, normal, penetration, load, tangent, energy, stick_stiffness, stick);
  }
};

/// Two yarns that went through each other: the direction from one to the other turned round within a step.
struct LostCrossing {
  std::int32_t first, second;  ///< elements
  Vector3 place;               ///< [mm]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(first, second, place);
  }
};

}  // namespace knitmech::contact
