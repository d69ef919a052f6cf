#pragma once

/// Every number that tunes the contact, with its unit, its usual value and what a change does.
namespace knitmech::contact {

/// Skin of the neighbour lists, in units of the larger yarn diameter [-]. Pairs nearer than this are kept in the list,
/// which stays valid until a node has moved half of it. Larger: fewer searches, more pairs in the list, most of which
/// sleep.
inline constexpr double kSkin = 0.4;

/// Motion of an element, as a share of the skin, from which on its neighbours are searched when those of another have
/// to be, at a half [-]. Smaller: fewer searches, of more elements each.
inline constexpr double kSearchEarly = 0.25;

/// Elements of which the neighbours are searched one by one [-]; more of them are sorted into a grid. What it costs:
/// time only.
inline constexpr std::size_t kFewElements = 60;

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
/// radii: one that grows beyond the second is cut into strips, one that shrinks below the first is integrated about its
/// closest places. Larger: faster, less exact where curved yarns lie side by side.
inline constexpr double kShortOverlap = 1.0;
inline constexpr double kLongOverlap = 1.5;

/// Size beyond which an overlap is not integrated about its closest places, even before the next look [sums of the
/// radii].
inline constexpr double kLongestOverlap = 3.0;

/// Least penetration with which the size of an overlap is judged [sums of the radii], so that yarns that bounce do not
/// change the way in which they are counted with every bounce, and yarns side by side that hardly touch are cut into
/// strips although the gap between them undulates with the elements.
inline constexpr double kJudgedOverlap = 0.04;

/// Lengths of strips and cells in long overlaps, in units of the sum of the radii [-]. Shorter: slower, more even where
/// yarns slide along each other.
inline constexpr double kStripLength = 0.2;
inline constexpr double kCellLength = 0.35;

/// Most strips or cells on one piece [-]; a piece that needs more is far too coarse.
inline constexpr int kMostOnPiece = 400;

/// How much nearer yarns may come between the points of strips and cells than at them [sums of the radii].
inline constexpr double kStripMargin = 0.01;

/// The yarn along which the distance to the other changes less is the one that is cut into strips; where the rises
/// differ by less than this factor, it stays what it was.
inline constexpr double kSidesAlike = 2.0;

/// How near yarns are followed before they touch [sums of the radii]. Larger: fewer looks, more places to follow.
inline constexpr double kFollowed = 0.12;

/// Motion of both yarns of a pair that is followed, until it is looked at again [sums of the radii]. Must be less than
/// kFollowed: what comes within reach is then known before it touches.
inline constexpr double kLookAtPairAgain = 0.11;

/// Motion that a pair must still have left to sleep on when others are looked at [sums of the radii]. Larger: fewer
/// looks, at more pairs each.
inline constexpr double kLookEarly = 0.05;

/// Fewest pairs of pieces that a thread looks at [-]; about ten microseconds of work.
inline constexpr std::size_t kPairsAtOnce = 8;

/// Largest turn of a piece of the smooth centreline in the stress-free yarn [rad]. Elements that turn by more are cut
/// for the contact: two pieces that hardly bend come closest in one place. Smaller: more pieces, more pairs to look at.
inline constexpr double kPieceTurn = 0.25;

/// Fewest and most pieces to an element [-]. Two allow for bending beyond the stress-free shape.
inline constexpr int kFewestPieces = 2;
inline constexpr int kMostPieces = 16;

/// Stiffness of the elastic stick of a crossing, as a share of its normal stiffness K [-], and that of a strip per sum
/// of the radii of its length. 1: the elastic slip before sliding is mu N / K, far below the yarn diameter. Long
/// overlaps carry the large forces, and their normal stiffness has grown beyond K by then. Larger asks for smaller time
/// steps.
inline constexpr double kStickStiffness = 1.0;
inline constexpr double kStripStickStiffness = 2.0;

/// Least cosine between the directions of a contact before and after it slides on to the next element [-]; the chords
/// of a coarse mesh turn by up to 45 degrees there. Smaller might take another contact close by for the same.
inline constexpr double kSameDirection = 0.5;

}  // namespace knitmech::contact
