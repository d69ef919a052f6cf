#include "contact/chord_contacts.h"

#include <algorithm>
#include <utility>

#include "base/segment_distance.h"
#include "contact/constants.h"
#include "contact/normal_law.h"

namespace knitmech::contact {

namespace {

const ChordContact* find(const std::vector<ChordContact>& contacts, std::uint64_t key) {
  const auto at = std::lower_bound(contacts.begin(), contacts.end(), key,
                                   [](const ChordContact& entry, std::uint64_t wanted) { return entry.key < wanted; });
  return at != contacts.end() && at->key == key ? &*at : nullptr;
}

/// The contact of a step before that slid on to a chord of this one; nullptr if there was none.
const ChordContact* moved_from(const std::vector<ChordContact>& before, const std::vector<ChordContact>& now,
                               const ContactPoint& point) {
  for (const int step_first : {0, -1, 1}) {
    for (const int step_second : {0, -1, 1}) {
      const std::int32_t first = point.first.element + step_first;
      const std::int32_t second = point.second.element + step_second;
      if (first < 0 || second < 0) continue;
      const ChordContact* same = find(before, chord_key(first, second));
      if (same == nullptr || dot(same->point.normal, point.normal) < kSameDirection) continue;
      if (find(now, same->key) == nullptr) return same;
    }
  }
  return nullptr;
}

/// Closest points of two chords.
struct Approach {
  ClosestPoints places;
  Vector3 between;  ///< from the first to the second [mm]
};

KNITMECH_INLINE Approach approach(const model::VectorArray& position, std::size_t i, std::size_t j) {
  const Vector3 start_first = position.at(i);
  const Vector3 start_second = position.at(j);
  const Vector3 along_first = position.at(i + 1) - start_first;
  const Vector3 along_second = position.at(j + 1) - start_second;
  const ClosestPoints at = closest_points(start_first, along_first, start_second, along_second);
  return {at, start_second + at.t * along_second - start_first - at.s * along_first};
}

}  // namespace

void look_at_chords(const ContactElements& elements, const model::VectorArray& position, Motion& motion,
                    PairWatch& watch, std::vector<NearChords>& near) {
  const std::vector<NearChords> before = std::exchange(near, {});
  auto old = before.cbegin();
  const auto keep_until = [&](ElementPair pair) {
    for (; old != before.cend() && old->pair < pair; ++old) near.push_back(*old);
    if (old != before.cend() && old->pair == pair) ++old;
  };
  watch.look_at_all(elements, kLookEarly * 2 * elements.largest_radius, motion, [&](ElementPair pair) {
    keep_until(pair);
    const auto i = static_cast<std::size_t>(pair.first);
    const auto j = static_cast<std::size_t>(pair.second);
    const double radii = elements.radius[i] + elements.radius[j];
    const double gap = length(approach(position, i, j).between) - radii;
    if (gap > kFollowed * radii) return gap;
    near.push_back({pair});
    return kLookAtPairAgain * radii;
  });
  near.insert(near.end(), old, before.cend());
}

void find_chord_contacts(const YarnElements& elements, const Motion& motion, const model::VectorArray& position,
                         double stiffness, std::vector<NearChords>& near, std::vector<ChordContact>& found) {
  found.clear();
  for (NearChords& chords : near) {
    const ElementPair pair = chords.pair;
    const auto i = static_cast<std::size_t>(pair.first);
    const auto j = static_cast<std::size_t>(pair.second);
    const double moved = motion.of(i) + motion.of(j);
    if (moved < chords.wake) continue;
    const Approach at = approach(position, i, j);
    const double radii = elements.radius[i] + elements.radius[j];
    const double distance = length(at.between);
    if (distance >= radii) {
      chords.wake = moved + distance - radii;
      continue;
    }
    const double penetration = radii - distance;
    found.push_back({chord_key(pair.first, pair.second),
                     {.first = {pair.first, at.places.s},
                      .second = {pair.second, at.places.t},
                      .normal = (1 / distance) * at.between,
                      .penetration = penetration,
                      .load = stiffness * normal_force(penetration, radii),
                      .tangent = stiffness * normal_tangent(penetration, radii),
                      .energy = stiffness * normal_energy(penetration, radii),
                      .stick_stiffness = kStickStiffness * stiffness,
                      .stick = {}}});
  }
}

void recall(const std::vector<ChordContact>& before, std::vector<ChordContact>& now) {
  auto old = before.begin();
  for (ChordContact& contact : now) {
    while (old != before.end() && old->key < contact.key) ++old;
    if (old != before.end() && old->key == contact.key) {
      contact.point.stick = old->point.stick;
    } else if (const ChordContact* moved = moved_from(before, now, contact.point)) {
      contact.point.stick = moved->point.stick;
    }
  }
}

}  // namespace knitmech::contact
