#pragma once

#include <TopoDS_Solid.hxx>

#include "exchange/yarn_samples.h"

namespace knitmech::exchange {

/// A tube as the solids of a CAD program (boundary representation of Open CASCADE): a wall and two flat ends, closed,
/// faces outwards, in mm.
///
/// The wall is one rational B-spline surface, an exact circle at kSolidStepsPerElement sections of every element and
/// smooth from section to section (C2): the centreline and the two axes of the section are cubic splines over the arc
/// length. From section to section the axes turn as little as they can (carried_across()).
/// @throws InputError for a yarn that bends more sharply than it is thick, whose wall would fold over itself
[[nodiscard]] TopoDS_Solid tube_solid(YarnRow row);

}  // namespace knitmech::exchange
