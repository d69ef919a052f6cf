#pragma once

#include <vector>

#include "contact/along_yarns.h"
#include "contact/contact_elements.h"
#include "contact/followed_contacts.h"

namespace knitmech::contact {

/// What contacts held on to before a look, by the places where they were.
class ContactMemory {
 public:
  /// \param contacts as they were before the look; its overlaps must live on, and only change through take_strips_of()
  ContactMemory(const YarnElements& elements, const ContactElements& pieces, const FollowedContacts& contacts);

  /// Memory of the contact that was nearest to two places and held on to something, seen from the first place. Its
  /// direction is left out, since it is another contact's.
  [[nodiscard]] SlipMemory near(YarnPlace first, YarnPlace second) const;

  /// Keeps the strips of an overlap that is about to be laid anew. Overlaps ascend from call to call.
  /// \param number of the overlap
  void take_strips_of(std::size_t number, Overlap& overlap);

  /// The strip of the overlap taken last that had a number and saw the other yarn near a place; null if there was none.
  [[nodiscard]] const Strip* strip(std::int32_t number, YarnPlace at, YarnPlace other) const;

 private:
  struct Taken {
    std::size_t number;
    std::vector<Strip> strips;
  };
  [[nodiscard]] const std::vector<Strip>& strips_of(std::size_t number) const;
  template <typename Call>
  void for_strips_around(YarnPlace place, double reach, const Call& call) const;

  AlongYarns along_;
  const ContactElements& pieces_;
  const std::vector<Overlap>& overlaps_;
  std::vector<Crossing> crossings_;
  ByElement crossings_on_;
  std::vector<Taken> taken_;
};

}  // namespace knitmech::contact
