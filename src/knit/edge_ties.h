#pragma once

#include <vector>

#include "knit/erc.h"
#include "knit/fabric.h"

namespace knitmech::knit {

/// The places where the first and the last stitch of every course cross the course above, seen along z: four to a
/// stitch, two at its head and two at the feet of the course above. Every course must be a yarn of its own that runs to
/// the right. @pre the courses interlock. Exact up to the sag of kCrossingPieces straight pieces per ERC, whatever the
/// number of elements.
[[nodiscard]] std::vector<YarnTie> edge_ties(const Erc& erc, const FabricLayout& layout);

}  // namespace knitmech::knit
