#pragma once

#include "base/thread_team.h"
#include "contact/centreline.h"
#include "contact/followed_contacts.h"
#include "contact/pair_watch.h"

namespace knitmech::contact {

/// Looks for places to follow on the smooth centreline, in all pairs of pieces that are awake, and drops those that are
/// followed no longer.
///
/// Pairs that are apart sleep until they might be nearer than kFollowed (constants.h). Pairs nearer than that give the
/// place where they come closest, a crossing, and strips along one of them where they overlap far; what is followed
/// already keeps its memory, what is new takes that of a contact nearby, if there is one.
///
/// How an overlap is counted, about its closest places or by strips, is decided here and stays until the next look: a
/// share that followed the overlap in every step would be a force without an energy, and heat the yarns up.
void look_for_contacts(const YarnElements& elements, const ContactElements& pieces, const Centreline& line,
                       Motion& motion, PairWatch& watch, const base::ThreadTeam& team, FollowedContacts& contacts);

}  // namespace knitmech::contact
