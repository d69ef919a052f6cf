#pragma once

/// Every number that tunes the contact, with its unit, its usual value and what a change does.
namespace knitmech::contact {

/// Skin of the neighbour lists, in units of the larger yarn diameter [-]. Pairs nearer than this are kept in the list,
/// which stays valid until a node has moved half of it. Larger: fewer searches, more pairs to look at in every step.
inline constexpr double kSkin = 0.4;

/// Elements of one yarn closer along the arc than this share of pi D [-] are not in contact with each other: to touch
/// there, the yarn would have to be bent tighter than its own radius. Smaller would lock short elements.
inline constexpr double kSelfContactArc = 0.5;

/// Line stiffness of contact on the smooth centreline, times the diameter, over the stiffness K of a crossing [-]: with
/// it, two straight yarns that cross at a right angle with a penetration of 5 % of D press with K times the
/// penetration.
inline constexpr double kLineStiffness = 2.37;

/// Half the length over which two yarns overlap [yarn diameters], up to which the gap is taken as a parabola about the
/// closest point. Longer overlaps are sampled. Larger: faster, less exact where yarns lie side by side.
inline constexpr double kShortOverlap = 0.6;

/// Distance of the samples in long overlaps, in yarn diameters [-]; the shortest of these overlaps then has five.
inline constexpr double kSampleSpacing = 0.25;

/// Most samples on one element [-]; an element that needs more is longer than 30 diameters and much too coarse.
inline constexpr double kMostSamples = 120;

/// Largest turn of a piece of the smooth centreline in the stress-free yarn [rad]. Elements that turn by more are cut
/// for the contact: two pieces that hardly bend come closest in one place. Smaller: more pieces, more pairs to look at.
inline constexpr double kPieceTurn = 0.25;

/// Fewest and most pieces to an element [-]. Two allow for bending beyond the stress-free shape.
inline constexpr int kFewestPieces = 2;
inline constexpr int kMostPieces = 16;

/// Stiffness of the elastic stick, as a share of the normal penalty [-]. 1: the elastic slip before sliding is mu times
/// the penetration, far below the yarn diameter. Larger asks for smaller time steps.
inline constexpr double kStickStiffness = 1.0;

/// Least cosine between the directions of a contact before and after it slides on to the next element [-]; the chords
/// of a coarse mesh turn by up to 45 degrees there. Smaller might take another contact close by for the same.
inline constexpr double kSameDirection = 0.5;

}  // namespace knitmech::contact
