#pragma once

#include <functional>
#include <vector>

#include "base/thread_team.h"
#include "contact/centreline.h"
#include "contact/contact_elements.h"
#include "contact/contact_memory.h"
#include "contact/followed_contacts.h"
#include "contact/neighbour_search.h"

namespace knitmech::contact {

/// Whether something else stands for the overlap at two places: the first on the piece with the smaller number.
using CountedElsewhere = std::function<bool(YarnPlace first, YarnPlace second)>;

/// What a look has come to.
struct LookedAt {
  std::vector<ElementPair> pairs;            ///< ascending
  std::vector<char> may_touch;               ///< each of them, soon
  std::vector<CrossingReach> changed_reach;  ///< of crossings, where they stand for overlaps or did before
};

/// Lays strips and cells (strips.h) wherever pieces are near each other and no crossing counts the overlap. Only those
/// overlaps are laid anew whose pairs of pieces were looked at and have changed, or near which a crossing has changed
/// its reach. A strip that lay there already keeps its memory, a new one takes that of the nearest contact before.
void lay_strips(const YarnElements& elements, const ContactElements& pieces, const Centreline& line,
                const LookedAt& looked_at, const CountedElsewhere& is_counted, ContactMemory& memory,
                const base::ThreadTeam& team, FollowedContacts& contacts);

}  // namespace knitmech::contact
