#pragma once

#include "knit/fabric.h"

namespace knitmech::knit {

/// Throws InputError unless the yarns of the fabric leave each other room, both the true curves and their straight
/// elements.
///
/// Checked in this order: the counts and the course spacing, the loop (check_loop()), whether the courses interlock
/// (check_interlock()), neighbouring courses, neighbouring wales, a loop with itself. The message says how much the
/// yarns overlap, where, and which key to change; for courses it reports the least loop.out_of_plane that keeps them
/// apart. diameter: D of the yarn [mm].
void check_fabric(const FabricLayout& layout, double diameter);

/// Throws InputError if a count is below 1 or the course spacing is not a positive number.
void check_layout(const FabricLayout& layout);

}  // namespace knitmech::knit
