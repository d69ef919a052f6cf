#pragma once

#include "contact/centreline.h"
#include "contact/followed_contacts.h"
#include "contact/pair_watch.h"

namespace knitmech::contact {

/// Looks for places to follow on the smooth centreline, in all pairs of pieces that are awake, and drops those that are
/// followed no longer.
///
/// Pairs that are apart sleep until they might be nearer than kFollowed (constants.h). Pairs nearer than that give the
/// place where they come closest, and samples along both where they overlap far; a place that is followed already keeps
/// its memory, a new one takes that of a place nearby, if there is one.
void look_for_contacts(const YarnElements& elements, const ContactElements& pieces, const Centreline& line,
                       const Motion& motion, PairWatch& watch, FollowedContacts& contacts);

}  // namespace knitmech::contact
