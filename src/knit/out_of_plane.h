#pragma once

#include <optional>

#include "knit/fabric.h"

namespace knitmech::knit {

/// First estimate of the least p without overlap [1/mm], D / (T (H - T)), all in mm. Of use for T < H only.
[[nodiscard]] double estimated_out_of_plane(const FabricLayout& layout, double diameter);

/// Least gap between different courses [mm] at an out-of-plane parameter p [1/mm], the smaller of that of the true
/// curve and that of the elements; +infinity for a fabric of one course. layout.loop.out_of_plane is not looked at.
[[nodiscard]] double gap_between_courses(const FabricLayout& layout, double diameter, double out_of_plane);

/// The least p [1/mm] that leaves a gap [mm] between all courses, for the true curve and for the elements; 0 for a
/// fabric of one course, empty if even a loop as deep as it is high does not leave it.
///
/// Found by bisection, from the side without overlap. In plan nothing depends on p and out of plane all distances grow
/// with it, so the gap of the curve never falls as p grows; the nodes of the elements shift a little along the curve.
[[nodiscard]] std::optional<double> least_out_of_plane(const FabricLayout& layout, double diameter, double gap);

/// The same as a plain number; throws InputError, with advice, where there is none.
[[nodiscard]] double required_out_of_plane(const FabricLayout& layout, double diameter, double gap);

/// The p that out_of_plane = "auto" stands for [1/mm]: the least one that leaves a gap of kAutomaticGap D.
///
/// Throws InputError, with advice, if the loop is impossible, the courses do not interlock or no p separates them.
[[nodiscard]] double automatic_out_of_plane(const FabricLayout& layout, double diameter);

}  // namespace knitmech::knit
