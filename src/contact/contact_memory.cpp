#include "contact/contact_memory.h"

#include <algorithm>
#include <utility>

namespace knitmech::contact {

namespace {

/// How far a new place may be from the one whose memory it takes [sums of the radii].
constexpr double kNearby = 1.0;

}  // namespace

ContactMemory::ContactMemory(const YarnElements& elements, const ContactElements& pieces,
                             const FollowedContacts& contacts)
    : along_(elements),
      pieces_(pieces),
      overlaps_(contacts.overlaps),
      crossings_(contacts.crossings),
      crossings_on_(elements.n_nodes()) {
  for (const Crossing& crossing : crossings_) crossings_on_.add(crossing.first.element);
}

const std::vector<Strip>& ContactMemory::strips_of(std::size_t number) const {
  const auto taken = std::lower_bound(taken_.begin(), taken_.end(), number,
                                      [](const Taken& entry, std::size_t wanted) { return entry.number < wanted; });
  return taken != taken_.end() && taken->number == number ? taken->strips : overlaps_[number].laid;
}

/// Calls for all strips on the elements within reach of a place.
template <typename Call>
void ContactMemory::for_strips_around(YarnPlace place, double reach, const Call& call) const {
  const std::int32_t each_side = along_.elements_within(reach);
  const std::int32_t m = pieces_.pieces_per_element;
  auto at =
      std::lower_bound(overlaps_.begin(), overlaps_.end(), CutPiece{(place.element - each_side) * m, 0}, is_before);
  for (; at != overlaps_.end() && at->strips.piece < (place.element + each_side + 1) * m; ++at) {
    for (const Strip& strip : strips_of(static_cast<std::size_t>(at - overlaps_.begin()))) call(strip);
  }
}

SlipMemory ContactMemory::near(YarnPlace first, YarnPlace second) const {
  double least = kNearby * along_.radii(first, second);
  const double reach = least;
  SlipMemory memory;
  const auto try_one = [&](YarnPlace a, YarnPlace b, const SlipMemory& stick, bool is_swapped) {
    if (is_swapped) std::swap(a, b);
    if (dot(stick.normal, stick.normal) == 0 || !along_.near(a, first, least) || !along_.near(b, second, least)) return;
    least = std::max(along_.distance(a, first), along_.distance(b, second));
    memory = is_swapped ? flipped(stick) : stick;
  };
  for (const bool is_swapped : {false, true}) {
    const YarnPlace here = is_swapped ? second : first;
    crossings_on_.around(here.element, along_.elements_within(reach), [&](std::size_t i) {
      try_one(crossings_[i].first, crossings_[i].second, crossings_[i].now.stick, is_swapped);
    });
    for_strips_around(here, reach,
                      [&](const Strip& strip) { try_one(strip.at, strip.other, strip.now.stick, is_swapped); });
  }
  memory.normal = {};
  return memory;
}

void ContactMemory::take_strips_of(std::size_t number, Overlap& overlap) {
  taken_.push_back({number, std::exchange(overlap.laid, {})});
}

const Strip* ContactMemory::strip(std::int32_t number, YarnPlace at, YarnPlace other) const {
  const Strip* known = nullptr;
  double least = kNearby * along_.radii(at, other);
  for (const Strip& old : taken_.back().strips) {
    if (old.number != number || !along_.near(old.other, other, least)) continue;
    least = along_.distance(old.other, other);
    known = &old;
  }
  return known;
}

}  // namespace knitmech::contact
