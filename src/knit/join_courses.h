#pragma once

#include "knit/fabric.h"

namespace knitmech::knit {

/// Joins the courses of a fabric, each a yarn of its own so far, to one yarn that runs through them to and fro: every
/// second course is turned round, and turning arcs (turning_arc.h) lead from each course to the next, the first at the
/// right edge. The nodes of the courses stay where they are.
void join_courses(Fabric& fabric);

}  // namespace knitmech::knit
