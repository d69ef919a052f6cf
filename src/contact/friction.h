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

  template <class Archive>
  void serialize(Archive& archive) {
    archive(normal, elastic_slip, slid, slips);
  }
};

/// The same memory, seen from the other yarn.
inline SlipMemory flipped(const SlipMemory& memory) {
  return {-1.0 * memory.normal, -1.0 * memory.elastic_slip, memory.slid, memory.slips};
}

/// How a stick has moved in one step.
struct Slide {
  Vector3 elastic_slip;  ///< stretch that is left [mm]
  double slid;           ///< slid off [mm]
  double loss;           ///< dissipated [mJ]
  double slips;          ///< 1 if the Coulomb limit was reached, else 0
};

/// Coulomb friction with an elastic stick (return mapping, Simo and Laursen 1992, doi:10.1016/0045-7949(92)90540-G):
/// the slip since the last step stretches the stick; if its force would exceed mu N, the rest is slid off and
/// dissipated.
///
/// A stick that is cut down because the normal force falls gives its energy up, too.
///
/// The stick is turned with the contact before: its part along the new normal is removed, its length kept. There are no
/// branches, so that contacts can be computed side by side.
/// \param elastic_slip stretch of the stick before [mm]   \param normal unit vector, first to second yarn
/// \param motion motion of the second yarn against the first since the last step [mm], at the contact
/// \param limit mu N [N]   \param stiffness of the stick [N/mm]
KNITMECH_INLINE Slide slide_stick(Vector3 elastic_slip, Vector3 normal, Vector3 motion, double limit,
                                  double stiffness) {
  const Vector3 flat = elastic_slip - dot(elastic_slip, normal) * normal;
  const double squared = dot(flat, flat);
  const double length_kept = squared > 0 ? std::sqrt(dot(elastic_slip, elastic_slip) / (squared > 0 ? squared : 1)) : 1;
  const Vector3 before = length_kept * flat;
  const Vector3 stretched = before + motion - dot(motion, normal) * normal;
  const double size = length(stretched);
  const double slips = stiffness * size > limit ? 1 : 0;
  const double kept = slips > 0 ? limit / (slips > 0 ? stiffness * size : 1) : 1;
  const double cut = stiffness * length(before) - limit;
  const double given_up = cut > 0 ? 0.5 * cut * cut / stiffness : 0;
  return {kept * stretched, (1 - kept) * size, slips * (limit * (1 - kept) * size + given_up), slips};
}

/// One step of friction at a contact.
struct FrictionStep {
  Vector3 force;  ///< on the second yarn [N]; the first gets the opposite
  double loss;    ///< dissipated in this step [mJ]
};

/// The same with the memory of the contact, which is brought up to date.
KNITMECH_INLINE FrictionStep friction_step(SlipMemory& memory, Vector3 normal, Vector3 motion, double limit,
                                           double stiffness) {
  const Slide slide = slide_stick(memory.elastic_slip, normal, motion, limit, stiffness);
  memory.normal = normal;
  memory.elastic_slip = slide.elastic_slip;
  memory.slid += slide.slid;
  memory.slips = slide.slips > 0;
  return {-stiffness * slide.elastic_slip, slide.loss};
}

}  // namespace knitmech::contact
