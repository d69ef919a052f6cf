#include "contact/chord_contacts.h"

#include <algorithm>
#include <utility>

#include "base/blocks.h"
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

/// Near chords, and contacts, that one thread takes at a time [-]; the same for any number of threads.
constexpr std::size_t kAtOnce = 64;

std::size_t n_shares(std::size_t n) {
  return (n + kAtOnce - 1) / kAtOnce;
}

/// Calls work(share, begin, end) for each share of n, on the threads of a team.
template <typename Work>
void for_shares(const base::ThreadTeam& team, std::size_t n, const Work& work) {
  team.for_ranges(n_shares(n), 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t share = from; share < to; ++share)
      work(share, share * kAtOnce, std::min((share + 1) * kAtOnce, n));
  });
}

/// Velocity of the material at a place of a chord [mm/s].
Vector3 chord_velocity(const model::State& state, YarnPlace place) {
  const auto i = static_cast<std::size_t>(place.element);
  return (1 - place.share) * state.velocity.at(i) + place.share * state.velocity.at(i + 1);
}

/// A force at a place of a chord, as its nodes feel it.
ElementLoad load_on_chord(YarnPlace place, Vector3 force) {
  return {place.element, {(1 - place.share) * force, place.share * force, {0, 0, 0}, {0, 0, 0}}};
}

/// Friction of a contact, and its whole force on the second yarn.
Vector3 force_of(const StepOfContacts& step, ContactPoint& point, ContactStep& done) {
  if (dot(point.stick.normal, point.normal) < 0 && !done.lost) {
    done.lost = LostCrossing{point.first.element, point.second.element,
                             step.line.node_position().at(static_cast<std::size_t>(point.first.element))};
  }
  const Vector3 motion =
      step.length * (chord_velocity(step.state, point.second) - chord_velocity(step.state, point.first));
  const double friction =
      step.law.friction.between(step.elements.section[static_cast<std::size_t>(point.first.element)],
                                step.elements.section[static_cast<std::size_t>(point.second.element)]);
  const FrictionStep stick =
      friction_step(point.stick, point.normal, motion, friction * point.load, point.stick_stiffness);
  done.friction_loss += stick.loss;
  done.largest_penetration = std::max(done.largest_penetration, point.penetration);
  return point.load * point.normal + stick.force;
}

}  // namespace

void look_at_chords(const ContactElements& elements, const model::VectorArray& position, Motion& motion,
                    PairWatch& watch, const base::ThreadTeam& team, std::vector<NearChords>& near) {
  const std::vector<NearChords> before = std::exchange(near, {});
  auto old = before.cbegin();
  const auto keep_until = [&](ElementPair pair) {
    for (; old != before.cend() && old->pair < pair; ++old) near.push_back(*old);
    if (old != before.cend() && old->pair == pair) ++old;
  };
  const auto look = [&](ElementPair pair) {
    keep_until(pair);
    const auto i = static_cast<std::size_t>(pair.first);
    const auto j = static_cast<std::size_t>(pair.second);
    const double radii = elements.radius_of(i) + elements.radius_of(j);
    const double gap = length(approach(position, i, j).between) - radii;
    if (gap > kFollowed * radii) return gap;
    near.push_back({pair});
    return kLookAtPairAgain * radii;
  };
  watch.look_at_all(elements, kLookEarly * 2 * elements.largest_radius, motion, look, team);
  near.insert(near.end(), old, before.cend());
}

void find_chord_contacts(const YarnElements& elements, const Motion& motion, const model::VectorArray& position,
                         double stiffness, std::span<NearChords> near, std::vector<ChordContact>& found) {
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

void ChordForces::find(const StepOfContacts& step, const base::ThreadTeam& team, std::vector<NearChords>& near) {
  std::swap(contacts_, before_);
  if (found_.size() < n_shares(near.size())) found_.resize(n_shares(near.size()));
  for_shares(team, near.size(), [&](std::size_t share, std::size_t begin, std::size_t end) {
    find_chord_contacts(step.elements, step.motion, step.line.node_position(), step.law.stiffness,
                        std::span(near).subspan(begin, end - begin), found_[share]);
  });
  contacts_.clear();
  for (std::size_t share = 0; share < n_shares(near.size()); ++share) {
    contacts_.insert(contacts_.end(), found_[share].begin(), found_[share].end());
  }
  recall(before_, contacts_);
}

ContactStep ChordForces::add(const StepOfContacts& step, const base::ThreadTeam& team, std::vector<NearChords>& near,
                             model::NodalLoads& loads) {
  find(step, team, near);
  const std::size_t n = contacts_.size();
  on_elements_.resize(2 * n);
  done_.assign(n_shares(n), {});
  for_shares(team, n, [&](std::size_t share, std::size_t begin, std::size_t end) {
    ContactStep done;
    for (std::size_t i = begin; i < end; ++i) {
      ContactPoint& point = contacts_[i].point;
      const Vector3 force = force_of(step, point, done);
      on_elements_[2 * i] = load_on_chord(point.second, force);
      on_elements_[2 * i + 1] = load_on_chord(point.first, -1.0 * force);
    }
    done_[share] = done;
  });
  team.for_ranges(loads.force.size(), base::kBlock, [&](std::size_t begin, std::size_t end) {
    for (const ElementLoad& load : on_elements_) add_within(load, begin, end, loads);
  });
  ContactStep sum;
  for (const ContactStep& done : done_) sum.add(done);
  return sum;
}

}  // namespace knitmech::contact
