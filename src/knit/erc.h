#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "knit/loop_shape.h"

namespace knitmech::knit {

/// The five pieces of the flat path of the ERC, in the order of the yarn.
enum class ErcPiece { head_flat, head_arc, leg, foot_arc, foot_flat };

inline constexpr int kErcPieces = 5;

/// The elementary representative cell: half a stitch, from the middle of the needle-loop head to the middle of the
/// sinker-loop foot. Made by make_erc(); everything else here follows from the shape.
///
/// In plan, from (0, H/2) to (L/2, -H/2): the flat l1; the head arc R1 about C1 = (l1, H/2 - R1), clockwise; the leg,
/// the inner common tangent of the two circles; the foot arc R2 about C2 = (L/2 - l2, -H/2 + R2), counter-clockwise;
/// the flat l2. With d = C2 - C1 the leg touches both circles along the unit vector u at the angle
///   angle(d) + acos((R1 + R2) / |d|),  at C1 + R1 u and at C2 - R2 u.
/// Out of plane the yarn lies on z = -p y^2, y from mid-height: head and foot at the back, the leg at the front.
struct Erc {
  LoopShape shape;

  /// P1 head middle, P2 end of the head flat, P3 start and P4 end of the leg, P5 end of the foot arc, P6 foot middle,
  /// P7 = C1 and P8 = C2, the middles of the two circles [mm], in plan.
  std::array<Eigen::Vector2d, 8> control_points = {};

  /// Inclination of the leg where it leaves the head arc (P3), against +x, turned clockwise, in plan [rad]: below pi/2
  /// the leg runs outwards from the head, above pi/2 it leans back under the head, as in jersey.
  double theta1 = 0;
  double theta2 = 0;  ///< [rad], the same where it enters the foot arc (P4); equal to theta1, as the leg is straight
  double head_sweep = 0;  ///< [rad], angle of the head arc
  double foot_sweep = 0;  ///< [rad], angle of the foot arc; equal to head_sweep, as both flats lie along x

  std::array<double, kErcPieces + 1> plan_start = {};  ///< [mm], plan length from P1 where each piece starts; the end
  std::vector<double> table_plan;  ///< [mm], plan lengths at which the arc length is tabulated, ascending
  std::vector<double> table_arc;   ///< [mm], arc length from P1 at each of table_plan

  double length = 0;  ///< [mm], arc length of the whole ERC, out-of-plane part included
};

/// A point of the centreline with its direction.
struct CurvePoint {
  Eigen::Vector3d position;  ///< [mm]
  Eigen::Vector3d tangent;   ///< unit vector, from head to foot
  double curvature = 0;      ///< [1/mm], of the space curve; jumps where two pieces meet
};

/// Builds the ERC of a loop. Throws InputError if no such ERC exists, see check_loop_shape().
[[nodiscard]] Erc make_erc(const LoopShape& shape);

/// The unit vector u from C1 to the start of the leg; the circles must leave room for a leg.
[[nodiscard]] Eigen::Vector2d leg_touch_direction(const LoopShape& shape);

/// Middle of the head circle, C1 [mm].
[[nodiscard]] Eigen::Vector2d head_circle_middle(const LoopShape& shape);

/// Middle of the foot circle, C2 [mm].
[[nodiscard]] Eigen::Vector2d foot_circle_middle(const LoopShape& shape);

/// The point at a plan length from P1 [mm], 0 to the end of erc.plan_start.
[[nodiscard]] CurvePoint point_at_plan_length(const Erc& erc, double plan_length);

/// Arc length from P1 [mm] to the point at a plan length [mm], to rounding accuracy.
[[nodiscard]] double arc_length_at(const Erc& erc, double plan_length);

/// Plan length from P1 [mm] of the point at an arc length [mm], the inverse of arc_length_at() to rounding accuracy.
[[nodiscard]] double plan_length_at(const Erc& erc, double arc_length);

/// The point at an arc length from P1 [mm], 0 to erc.length; an arc length outside is moved to the nearer end.
[[nodiscard]] CurvePoint point_at_arc_length(const Erc& erc, double arc_length);

/// The piece in which an arc length from P1 [mm] lies; where two meet, the later one.
[[nodiscard]] ErcPiece piece_at_arc_length(const Erc& erc, double arc_length);

/// The n + 1 points that cut the ERC into n >= 1 pieces of equal arc length, P1 and P6 included.
[[nodiscard]] std::vector<CurvePoint> equal_arc_points(const Erc& erc, int n_pieces);

}  // namespace knitmech::knit
