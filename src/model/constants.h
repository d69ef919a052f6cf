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

/// Elements of a half stitch [-] that fabric.element_length = "auto" aims at; 10, as fabric.elements_per_erc.
inline constexpr double kElementsPerHalfStitch = 10;

/// Fewest elements of a yarn [-] from a file. A short end of yarn still bends.
inline constexpr int kFewestElements = 4;

/// Largest angle [degrees] by which a yarn may turn within one element. Beyond, an element cuts the bend off.
inline constexpr double kLargestTurn = 90;

/// How far a yarn must go back along y to have turned, in yarn diameters [-]; 2. The turns tell the half stitches of a
/// fabric from a file; smaller counts waves of a yarn that is not smooth.
inline constexpr double kTurnHeight = 2;

/// Overlap of yarns from a file that still counts as touching, as a share of the yarn diameter [-]. Coordinates of 32
/// bits and the straight pieces of the search have to fit in; its contact forces are far below those of a test.
inline constexpr double kFileOverlap = 5e-3;

/// Straight pieces of an element [-] when the overlap of yarns from a file is searched on the smooth centreline; 16.
/// The sag of a piece h / 16 on a bend of radius R is (h / 16)^2 / (8 R): below 1 % of D for elements up to 4 sqrt(D
/// R).
inline constexpr int kClearancePieces = 16;

/// How far `knitmech check` looks for the least gap of yarns from a file, in yarn diameters between centrelines [-].
inline constexpr double kGapReach = 3;

/// Most elements of a model [-]; needs about 20 GB. What is larger is a slip of the keyboard.
inline constexpr double kMostElements = 20e6;

}  // namespace knitmech::model
