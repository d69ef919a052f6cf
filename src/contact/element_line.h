#pragma once

#include "contact/curve.h"
#include "contact/line_potential.h"

namespace knitmech::contact {

/// How a place hangs on the two nodes of its element: it moves by start dx_a + end dx_b, and where the nodes turn by
/// small rotations w_a and w_b, by w_a x start_arm + w_b x end_arm besides.
struct Hold {
  double start, end;
  Vector3 start_arm, end_arm;  ///< [mm], zero on chords
};

/// Velocity of a place [mm/s].
/// \param velocity of the nodes [mm/s]   \param turning their angular velocities [1/s]
KNITMECH_INLINE Vector3 velocity_of(const Hold& by, Vector3 start_velocity, Vector3 end_velocity, Vector3 start_turning,
                                    Vector3 end_turning) {
  return by.start * start_velocity + by.end * end_velocity + cross(start_turning, by.start_arm) +
         cross(end_turning, by.end_arm);
}

/// What a load on an element does to its two nodes.
struct EndLoads {
  Vector3 start_force, end_force;    ///< [N]
  Vector3 start_moment, end_moment;  ///< [N mm]
};

/// The smooth line of one element as its two nodes hold it.
struct ElementLine {
  double length;                       ///< [mm], along the stress-free yarn
  Vector3 start, end;                  ///< nodes [mm]
  Vector3 start_tangent, end_tangent;  ///< turned with the nodes, unit vectors
  Vector3 start_bow, end_bow;          ///< halves of the bow, turned with the nodes [mm]

  [[nodiscard]] KNITMECH_INLINE Curve curve() const {
    return {start, end, length * start_tangent, length * end_tangent, start_bow + end_bow};
  }

  /// \param weights hermite() at a place
  [[nodiscard]] KNITMECH_INLINE Hold hold(HermiteWeights weights) const {
    return {weights.start, weights.end, (length * weights.start_slope) * start_tangent + weights.bow * start_bow,
            (length * weights.end_slope) * end_tangent + weights.bow * end_bow};
  }

  /// Gives a load on the curve to the nodes, so that it does the same work there.
  [[nodiscard]] KNITMECH_INLINE EndLoads to_nodes(double place, const CurveLoad& load) const {
    const HermiteWeights value = hermite(place);
    const HermiteWeights slope = hermite_slope(place);
    const HermiteWeights bend = hermite_bend(place);
    // The weights of the two positions add up to one, and so those of their derivatives to zero.
    const Vector3 on_end = value.end * load.force + slope.end * load.slope + bend.end * load.bend;
    const Vector3 on_bow = value.bow * load.force + slope.bow * load.slope + bend.bow * load.bend;
    const Vector3 turns_start =
        value.start_slope * load.force + slope.start_slope * load.slope + bend.start_slope * load.bend;
    const Vector3 turns_end = value.end_slope * load.force + slope.end_slope * load.slope + bend.end_slope * load.bend;
    return {load.force - on_end, on_end, length * cross(start_tangent, turns_start) + cross(start_bow, on_bow),
            length * cross(end_tangent, turns_end) + cross(end_bow, on_bow)};
  }
};

}  // namespace knitmech::contact
