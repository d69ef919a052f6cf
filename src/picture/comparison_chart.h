#pragma once

#include <string>

#include "compare/comparison.h"
#include "picture/chart.h"

namespace knitmech::picture {

/// The simulated curve over the mean of the measured ones and, of several specimens, their range as a shaded band.
///
/// @param width [mm]: the force on a fabric of this width; 0: the force per width. In mN or mN/mm if no force reaches a
/// tenth of the unit.
[[nodiscard]] Chart comparison_chart(const compare::Comparison& comparison, const std::string& title, double width);

}  // namespace knitmech::picture
