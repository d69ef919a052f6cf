#pragma once

#include <optional>
#include <vector>

#include "curves/nearest_yarns.h"
#include "model/case.h"
#include "model/model.h"

namespace knitmech::model {

/// The nodes of a fabric from a file of yarns (Case::Fabric::yarn_file), with what follows from them: tangents,
/// middles, arc lengths, node sets and half_stitch_length. Sections, contact and test are for build_model() to add.
///
/// Every yarn is the smooth line that its file means (curves::smooth_line()), cut into elements of equal arc length of
/// nearly fabric.element_length. half_stitch_length is the yarn's length over the number of pieces on which y rises or
/// falls; it is a measure of length for the solver, and ten elements of it are the mesh where the case gives none.
///
/// Node sets: bottom_feet and top_heads are all nodes within fabric.grip_depth of the lowest and of the highest node
/// along y, for a knit the foot arcs of the lowest course and the head arcs of the top one. The depth that is chosen is
/// the yarn diameter, or half an element where that is more. left_edge and right_edge: the ends of each yarn, the one
/// with the lower x left.
///
/// @throws InputError with advice if yarns overlap by more than kFileOverlap of the diameter, for a yarn that is
///         shorter than it is thick, for elements that are too many or too long for the bends, and for a fabric that is
///         too low for the grips
[[nodiscard]] Model model_from_file(const Case& input);

/// How far the grips of a fabric from a file reach [mm]. @param model of that fabric
[[nodiscard]] double grip_depth_of(const Case& input, const Model& model);

/// The closest places of the yarns of a fabric from a file, as the contact sees them: on the smooth centreline or on
/// the elements; empty if none are nearer than the reach. @param model of that fabric @param reach between centrelines
/// [mm]
[[nodiscard]] std::optional<curves::NearestYarns> nearest_in(const Case& input, const Model& model, double reach);

}  // namespace knitmech::model
