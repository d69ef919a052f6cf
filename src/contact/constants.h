#pragma once

/// Every number that tunes the contact, with its unit, its usual value and what a change does.
namespace knitmech::contact {

/// Skin of the neighbour lists, in units of the larger yarn diameter [-]. Pairs nearer than this are kept in the list,
/// which stays valid until a node has moved half of it. Larger: fewer searches, more pairs in the list, most of which
/// sleep.
inline constexpr double kSkin = 0.8;

/// Motion of a yarn after which all crossings are checked [yarn diameters]; see crossing_watch.h.
inline constexpr double kCheckCrossings = 0.2;

/// Elements of one yarn closer along the arc than this share of pi D [-] are not in contact with each other: to touch
/// there, the yarn would have to be bent tighter than its own radius. Smaller would lock short elements.
inline constexpr double kSelfContactArc = 0.5;

/// Penetration, as a share of the sum of the radii [-], at which two straight yarns that cross at a right angle on the
/// smooth centreline press with the stiffness K of a crossing times the penetration. Smaller: harder contact under the
/// small forces of a loose fabric, and smaller time steps under large ones.
inline constexpr double kReferenceOverlap = 0.02;

/// Size of an overlap, root of the sum of the squares of its half lengths along both yarns, in units of the sum of the
/// radii: one that grows beyond the second is sampled along the yarns, one that shrinks below the first is integrated
/// about its closest places. Larger: faster, less exact where curved yarns lie side by side.
inline constexpr double kShortOverlap = 1.0;
inline constexpr double kLongOverlap = 1.5;

/// Size beyond which an overlap is not integrated about its closest places, even before the next look [sums of the
/// radii].
inline constexpr double kLongestOverlap = 3.0;

/// Least penetration with which the size of an overlap is judged [sums of the radii]: yarns that lie side by side and
/// hardly touch are sampled all the same, although the gap between them undulates with the elements.
inline constexpr double kJudgedOverlap = 0.01;

/// Distance of the samples in long overlaps, in units of the sum of the radii [-].
inline constexpr double kSampleSpacing = 0.25;

/// Most samples on one element [-]; an element that needs more is far too coarse.
inline constexpr int kMostSamples = 400;

/// How near yarns are followed before they touch, and how much they may move until pairs that touch are searched for
/// new contacts [sums of the radii]. The first must be more than twice the second, since both yarns move.
inline constexpr double kFollowed = 0.05;
inline constexpr double kLookAgain = 0.02;

/// Least motion between two looks at any pairs [sums of the radii]: looks that are due soon are done together.
inline constexpr double kLookTogether = 0.005;

/// Largest turn of a piece of the smooth centreline in the stress-free yarn [rad]. Elements that turn by more are cut
/// for the contact: two pieces that hardly bend come closest in one place. Smaller: more pieces, more pairs to look at.
inline constexpr double kPieceTurn = 0.25;

/// Fewest and most pieces to an element [-]. Two allow for bending beyond the stress-free shape.
inline constexpr int kFewestPieces = 2;
inline constexpr int kMostPieces = 16;

/// Stiffness of the elastic stick of a crossing, as a share of its normal stiffness K [-]; long overlaps have it per
/// sum of the radii of their length. 1: the elastic slip before sliding is mu N / K, far below the yarn diameter.
/// Larger asks for smaller time steps.
inline constexpr double kStickStiffness = 1.0;

/// Least cosine between the directions of a contact before and after it slides on to the next element [-]; the chords
/// of a coarse mesh turn by up to 45 degrees there. Smaller might take another contact close by for the same.
inline constexpr double kSameDirection = 0.5;

}  // namespace knitmech::contact
