#pragma once

#include "knit/loop_shape.h"

namespace knitmech::knit {

/// Throws InputError, naming the key to change and by how much, unless an ERC of this shape exists (knit/erc.h):
/// lengths and radii positive and finite, flats and p not negative, room for a leg between the two circles,
/// |C2 - C1| > R1 + R2, and a leg that runs down from the head to the foot.
void check_loop_shape(const LoopShape& shape);

/// The same, and throws InputError if yarn of diameter D [mm] cannot take this shape: an arc tighter than the yarn's
/// own radius, or heads or feet so wide that they overlap those of the next wale, 2 (l1 + R1) + D > L or 2 (l2 + R2) +
/// D > L (where the leg leans back, so that the arc reaches its full width).
void check_loop(const LoopShape& shape, double diameter);

}  // namespace knitmech::knit
