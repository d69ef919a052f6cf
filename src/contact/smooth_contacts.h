#pragma once

#include <vector>

#include "contact/centreline.h"
#include "contact/contact_points.h"

namespace knitmech::contact {

/// Where a pair of pieces came closest when last looked at: Newton's method starts there again.
struct PairPlaces {
  double s = -1, t = -1;  ///< negative: not looked at yet
};

/// Finds all contact points of a list of element pairs, on the smooth centreline. Replaces `found`; ascending by key.
///
/// Two yarns press on each other with a line load: where the other yarn's centreline is nearer than the sum of the
/// radii, each millimetre of a yarn carries the normal law (normal_law.h) of its penetration d(s), times a line
/// stiffness k:
///
///     energy = 1/2 k  integral over yarn a of E(d_a(s)) ds  +  1/2 k  integral over yarn b of E(d_b(t)) dt.
///
/// So yarns that cross and yarns that lie side by side follow one law that does not know how the yarn is cut into
/// elements. Every element integrates over itself; where a contact slides over a node, one element hands over to the
/// next gradually.
///
/// A crossing is short: about the closest point the gap is a parabola, whose curvature follows from both curves, and
/// its integral is known. Its resultant acts as one contact point. Longer overlaps are sampled at even distances. For
/// two straight yarns at an angle a and small penetration d the first gives  F = 4/3 k d sqrt(2 D d) / sin a.
void find_smooth_contacts(const ContactElements& elements, const std::vector<ElementPair>& pairs,
                          const Centreline& centreline, PairClock& clock, std::vector<PairPlaces>& places,
                          std::vector<ContactPoint>& found);

}  // namespace knitmech::contact
