#pragma once

/// Every number that tunes the contact, with its unit, its usual value and what a change does.
namespace knitmech::contact {

/// Skin of the neighbour lists, in units of the larger yarn diameter [-]. Pairs nearer than this are kept in the list,
/// which stays valid until a node has moved half of it. Larger: fewer searches, more pairs to look at in every step.
inline constexpr double kSkin = 0.4;

/// Elements of one yarn closer along the arc than this share of pi D [-] are not in contact with each other: to touch
/// there, the yarn would have to be bent tighter than its own radius. Smaller would lock short elements.
inline constexpr double kSelfContactArc = 0.5;

/// Stiffness of the elastic stick, as a share of the normal penalty [-]. 1: the elastic slip before sliding is mu times
/// the penetration, far below the yarn diameter. Larger asks for smaller time steps.
inline constexpr double kStickStiffness = 1.0;

/// Least cosine between the directions of a contact before and after it slides on to the next element [-]; the chords
/// of a coarse mesh turn by up to 45 degrees there. Smaller might take another contact close by for the same.
inline constexpr double kSameDirection = 0.5;

}  // namespace knitmech::contact
