#pragma once

#include <functional>
#include <vector>

#include "contact/along_yarns.h"
#include "contact/centreline.h"
#include "contact/contact_elements.h"
#include "contact/followed_contacts.h"

namespace knitmech::contact {

/// Whether something else stands for the overlap at two places: the first on the piece with the smaller number.
using CountedElsewhere = std::function<bool(YarnPlace first, YarnPlace second)>;

/// What contacts held on to before a look, by the places where they were. The contacts must live on.
class ContactMemory {
 public:
  ContactMemory(const YarnElements& elements, const FollowedContacts& before);

  /// Memory of the contact that was nearest to two places and held on to something, seen from the first place. Its
  /// direction is left out, since it is another contact's.
  [[nodiscard]] SlipMemory near(YarnPlace first, YarnPlace second) const;

  /// The strip that lay at a place and saw the other yarn near another place; null if there was none.
  [[nodiscard]] const Strip* strip(YarnPlace at, YarnPlace other) const;

 private:
  struct Held {
    YarnPlace first, second;
    SlipMemory stick;
  };
  AlongYarns along_;
  const FollowedContacts& before_;
  std::vector<Held> held_;  ///< every contact, seen from either yarn
  ByElement held_on_, strips_on_;
};

/// Pairs of pieces that a look has come to, ascending: all of them, and those that may touch soon.
struct PairsLookedAt {
  std::vector<ElementPair> all, touching;
};

/// Lays strips and cells (strips.h) wherever pieces are near each other and no crossing counts the overlap; replaces
/// those of before. Pairs that were not looked at keep the touches that they had. A strip that lay there already keeps
/// its memory, a new one takes that of the nearest contact before.
void lay_strips(const YarnElements& elements, const ContactElements& pieces, const Centreline& line,
                const PairsLookedAt& looked_at, const CountedElsewhere& is_counted, const ContactMemory& memory,
                FollowedContacts& contacts);

}  // namespace knitmech::contact
