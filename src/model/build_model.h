#pragma once

#include "knit/fabric.h"
#include "model/case.h"
#include "model/model.h"

namespace knitmech::model {

/// Builds the finite-element model of a case: resolves an automatic out-of-plane parameter, checks that the yarns leave
/// each other room, and lays nodes, sections, node sets, contact and test.
///
/// Node sets: bottom_feet, the nodes of the lowest course within one tenth of the ERC's arc length from a foot middle,
/// and top_heads, the same about the head middles of the top course; the middle itself always belongs to it. At N10
/// that is the middle and one node on each side: 28 and 27 nodes for 9 wales. left_edge and right_edge are the first
/// and last node of each course. Contact stiffness: contact.stiffness of the case, or else 0.1 EA / D
/// (kContactStiffnessShare). Sections: 0 the yarn, with its measured curve and its strength, 1 the edge yarn of an
/// adjusted fabric, which is linear and never breaks. A fabric from a file of yarns: model_from_file(). Throws
/// InputError, with advice, for a geometry or a yarn that cannot be.
[[nodiscard]] Model build_model(const Case& input);

/// The fabric that build_model() makes its nodes of, out_of_plane resolved. Throws InputError like build_model().
[[nodiscard]] knit::Fabric build_fabric(const Case& input);

/// The layout of the fabric of a case, with the out-of-plane parameter that the case gives or leaves to the program.
/// Throws InputError where the latter finds none.
[[nodiscard]] knit::FabricLayout resolved_layout(const Case& input);

}  // namespace knitmech::model
