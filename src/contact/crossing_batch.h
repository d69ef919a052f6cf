#pragma once

#include <array>
#include <cstddef>

#include "contact/element_line.h"

namespace knitmech::contact {

/// Contacts that are evaluated side by side, one in each lane of the processor's vectors.
inline constexpr std::size_t kLanes = 8;

using LaneNumbers = std::array<double, kLanes>;

struct LaneVectors {
  LaneNumbers x{}, y{}, z{};

  [[nodiscard]] KNITMECH_INLINE Vector3 at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
  KNITMECH_INLINE void set(std::size_t lane, Vector3 v) {
    x[lane] = v.x;
    y[lane] = v.y;
    z[lane] = v.z;
  }
};

/// The element of one yarn with its two nodes, and the place on it that is followed.
struct LaneSides {
  LaneVectors start{}, end{};                    ///< nodes [mm]
  LaneVectors start_tangent{}, end_tangent{};    ///< unit vectors
  LaneVectors start_bow{}, end_bow{};            ///< halves of the bow [mm]
  LaneVectors start_velocity{}, end_velocity{};  ///< [mm/s]
  LaneVectors start_turning{}, end_turning{};    ///< angular velocities [1/s]
  LaneNumbers length{};                          ///< stress-free [mm]
  LaneNumbers share{};                           ///< of the place, in and out
  LaneNumbers to_end{};                          ///< from the place to the nearer end of the yarn [mm]
  LaneVectors start_force{}, end_force{};        ///< out [N]
  LaneVectors start_moment{}, end_moment{};      ///< out [N mm]
};

/// Puts an element into a lane, and takes it out.
KNITMECH_INLINE void set_element(LaneSides& side, std::size_t lane, const ElementLine& line) {
  side.start.set(lane, line.start);
  side.end.set(lane, line.end);
  side.start_tangent.set(lane, line.start_tangent);
  side.end_tangent.set(lane, line.end_tangent);
  side.start_bow.set(lane, line.start_bow);
  side.end_bow.set(lane, line.end_bow);
  side.length[lane] = line.length;
}
KNITMECH_INLINE ElementLine element(const LaneSides& side, std::size_t lane) {
  return {side.length[lane],         side.start.at(lane),     side.end.at(lane),    side.start_tangent.at(lane),
          side.end_tangent.at(lane), side.start_bow.at(lane), side.end_bow.at(lane)};
}

/// Up to kLanes contacts: what goes into a step of theirs, and what comes out of it.
struct ContactBatch {
  std::size_t n = 0;
  LaneSides first{}, second{};
  LaneNumbers radii{}, density{}, friction{}, stick_stiffness{};
  LaneVectors elastic_slip{}, normal{};  ///< in and out; the normal is that of the step before, or zero
  LaneNumbers slid{}, slipped{};         ///< out: path slid in this step [mm]; 1 where the Coulomb limit was reached
  LaneNumbers regular{};                 ///< out: 1 where the lane holds the result; else it must be computed otherwise
  LaneNumbers penetration{}, load{}, tangent{}, energy{}, loss{};  ///< out
  LaneNumbers turned_round{};                                      ///< out: 1 where the normal has turned round
};

/// One step of crossings (line_potential.h, crossing_load()) with friction, for small overlaps amid the yarns whose
/// places move little; others are left as not regular.
/// \param step [s]
void evaluate_crossings(ContactBatch& batch, double step);

}  // namespace knitmech::contact
