#pragma once

#include "knit/erc.h"
#include "knit/fabric.h"

namespace knitmech::knit {

/// Builds the centrelines of a fabric from its layout (knit/fabric.h): stitch = ERC and its mirror image, course = W
/// stitches in a row, fabric = C courses a distance T apart.
///
/// Every ERC is cut into N elements of equal arc length, so the basic structure has 2 N W C elements and 2 N W C + C
/// nodes. Adjusted has the turning arcs besides (turning_arc.h). Whether the yarns leave each other room is not asked
/// here, see check_fabric(). Throws InputError if wales, courses or elements_per_erc is below 1, if course_spacing is
/// not positive, or if there is no such ERC.
[[nodiscard]] Fabric build_fabric(const FabricLayout& layout);

/// The same from an ERC of layout.loop that is already there.
[[nodiscard]] Fabric build_fabric(const FabricLayout& layout, const Erc& erc);

}  // namespace knitmech::knit
