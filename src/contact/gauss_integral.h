#pragma once

#include <vector>

#include "base/vector3.h"

namespace knitmech::contact {

/// A straight piece of a yarn.
struct Segment {
  Vector3 start, end;  ///< [mm]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(start, end);
  }
};

/// A piece that has moved.
struct MovedSegment {
  Segment before, now;
};

/// Gauss integral of two segments [-],
///
///     G = 1 / (4 pi)  integral integral  (dx_a x dx_b) . (x_a - x_b) / |x_a - x_b|^3,
///
/// between -1/2 and 1/2: how many of all directions of view, with their sign, show one crossing the other. The
/// differences x_b - x_a fill a parallelogram, and G is the solid angle under which it is seen from zero, over 4 pi
/// (Banchoff 1976, Indiana University Mathematics Journal 25, 1171; Klenin and Langowski 2000,
/// doi:10.1002/1097-0282(20001015)54:5<307::AID-BIP20>3.0.CO;2-Y). Continuous while the segments move, and jumps by 1
/// when one passes through the other. 0 for segments in one plane and for those of no length; where they meet, one of
/// the values on either side.
[[nodiscard]] double gauss_integral(const Segment& a, const Segment& b);

/// The same of two polylines [-], the sum over their segments. The linking number if both are closed: the last point is
/// the first one.
[[nodiscard]] double gauss_integral(const std::vector<Vector3>& a, const std::vector<Vector3>& b);

/// How often two segments passed through each other while they moved, with the sign of the jump of G [-].
///
/// While the four end points move, the differences x_b - x_a sweep over a body that is bounded by the parallelograms
/// before and now and by four sides, which the differences to an end point sweep over. How often the surface winds
/// around zero is the number of passes; it is the jump of G freed from all that changes gradually, so no threshold is
/// needed. The end points go straight; sides are split into triangles in the same way for both segments that share an
/// end point, so that a pass there is counted by one of them.
/// \param offset added to b [mm]: yarns that meet exactly are on the side that it says
[[nodiscard]] int passes(const MovedSegment& a, const MovedSegment& b, Vector3 offset);

}  // namespace knitmech::contact
