#pragma once

#include <vector>

#include "model/frame.h"

namespace knitmech::picture {

/// A frame between two others of one model, for films: every field on the straight line from the one to the other,
/// rotations on the shortest way. share is 0 at the first and 1 at the second.
///
/// It is no result of the simulation. Of the history row it has strain, time, displacement and the forces of the grips;
/// contacts are those of the nearer frame, and what is broken in the second is broken. A field that is not finite in
/// one of the two is so in the result.
[[nodiscard]] model::Frame frame_between(const model::Frame& frame_a, const model::Frame& frame_b, double share);

/// The row of a history at a strain [-], strain, time, displacement and forces on the line between the two rows beside
/// it; the first or last row outside. history must not be empty and ascend in strain.
[[nodiscard]] model::HistoryRow row_at_strain(const std::vector<model::HistoryRow>& history, double strain);

}  // namespace knitmech::picture
