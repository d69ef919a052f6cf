#pragma once

#include <optional>
#include <vector>

#include "knit/constants.h"
#include "knit/erc.h"
#include "knit/fabric.h"

namespace knitmech::knit {

/// A place where the ERC and the next course cross in plan, seen along z.
struct PlanCrossing {
  double arc_length = 0;        ///< [mm], from the head middle of the ERC
  double upper_arc_length = 0;  ///< [mm], on the next course, from the left foot of the stitch above the ERC
  double lead = 0;  ///< [mm^2], how far the lower course lies in front of the upper, (z_lower - z_upper) / p
};

/// The crossings of one ERC with the course a distance T above it [mm], from its head to its foot, on straight pieces
/// of equal arc length. On the true curve lead = T (T - 2 y), y from the mid-height of the lower course.
[[nodiscard]] std::vector<PlanCrossing> plan_crossings(const Erc& erc, double course_spacing, int pieces_per_erc);

/// Whether two courses a distance T apart [mm] hold each other as in plain jersey: each half loop crosses the next
/// course twice, the upper in front at the lower one's head and the lower in front at the upper one's foot.
///
/// This depends on the shape in plan alone, as p > 0 only scales the lead. It needs T somewhat less than H.
[[nodiscard]] bool courses_interlock(const Erc& erc, double course_spacing, int pieces_per_erc = kCrossingPieces);

/// Whether two courses a distance apart [mm] do not cross in plan, neither as true curves nor as elements.
[[nodiscard]] bool courses_lie_clear(const Erc& erc, double distance, int elements_per_erc);

/// The largest course spacing below a given one at which the courses interlock [mm], within 1 % of H below the true
/// limit; empty if there is none.
[[nodiscard]] std::optional<double> largest_interlocking_spacing(const Erc& erc, double below);

/// Throws InputError, with the spacing or the number of elements that would do, unless the courses of a fabric hold
/// each other as in plain jersey: every course interlocks with the next, on the true curve and on its elements, and
/// lies clear of all further ones in plan. A fabric of one course passes.
void check_interlock(const Erc& erc, const FabricLayout& layout);

}  // namespace knitmech::knit
