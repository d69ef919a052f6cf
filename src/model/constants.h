#pragma once

namespace knitmech::model {

/// Default contact stiffness as a share of EA / D [-]; usually 0.1. It does not depend on the mesh, so that a contact
/// of a given penetration carries the same force at every mesh. Larger gives less penetration and a smaller stable
/// step, smaller lets yarns sink into each other visibly.
inline constexpr double kContactStiffnessShare = 0.1;

/// Bending stiffness of the edge yarn that "auto" stands for [N mm^2]: the published soft multifilament.
inline constexpr double kEdgeBendingStiffness = 5e-6;

/// Share of the ERC's arc length [-] on each side of a foot or head middle that a grip holds; 0.1 for every mesh, so
/// that the grips hold the same piece of yarn. Larger stiffens the rows at the grips.
inline constexpr double kGripShare = 0.1;

/// Slack when a node's distance from a loop middle is compared with the length of the grip, as a share of the ERC [-].
/// Only rounding has to fit in: at N = 10 the second node lies exactly at the end of the grip.
inline constexpr double kGripRounding = 1e-9;

}  // namespace knitmech::model
