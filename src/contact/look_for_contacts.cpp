#include "contact/look_for_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/segment_distance.h"
#include "contact/along_yarns.h"
#include "contact/closest_places.h"
#include "contact/constants.h"
#include "contact/curve_distance.h"
#include "contact/lay_strips.h"

namespace knitmech::contact {

namespace {

/// Distance from the end of a piece within which a place lies on it [share of the piece].
constexpr double kOnEnd = 1e-6;

/// Two places that were followed to the same point differ by no more than this [sums of the radii].
constexpr double kSamePlace = 0.02;

/// Beyond this many half lengths of its parabola an overlap must have ended; up to it the gap must have risen by this
/// share of what the parabola says, for an overlap that was integrated about its closest places or by strips so far.
constexpr double kBeyondEnd = 1.25;

/// How far a crossing stands for what lies beyond that besides [sums of the radii].
constexpr double kMarginOfReach = 0.25;

/// Change of where a crossing lies or how far it reaches, which leaves the strips around it as they are [sums of the
/// radii]; well below kMarginOfReach.
constexpr double kLittleChange = 0.05;

constexpr double kRiseOfShort = 0.8;
constexpr double kRiseOfLong = 0.9;

/// Whether a closest place on a piece is one of the whole yarn: not if it is held at an end beyond which the yarn comes
/// nearer. \param slope derivative of half the squared distance by the place [mm^2]  \param bend its second derivative
bool is_of_yarn(const ContactElements& pieces, std::int32_t piece, double place, double slope, double bend) {
  const auto at = static_cast<std::size_t>(piece);
  if (place >= 1 - kOnEnd && slope < -kOnEnd * bend) return !pieces.has_next(at);
  if (place <= kOnEnd && slope > kOnEnd * bend) return !pieces.has_previous(at);
  return true;
}

/// Where two yarns come closest.
struct ClosestPlaces {
  YarnPlace first, second;
  double gap;  ///< [mm]
};

class Look {
 public:
  Look(const YarnElements& elements, const ContactElements& pieces, const Centreline& line, const ContactMemory& memory,
       FollowedContacts& contacts)
      : elements_(elements),
        pieces_(pieces),
        line_(line),
        along_(elements),
        memory_(memory),
        contacts_(contacts),
        crossings_on_(elements.n_nodes()) {
    for (const Crossing& crossing : contacts.crossings) crossings_on_.add(crossing.first.element);
  }

  /// What a pair of pieces looks like.
  struct PairView {
    double sleep = 0;                        ///< motion of both yarns until the next look [mm]
    bool is_as_before = false;               ///< has not come nearer by so much that anything has to be done
    bool may_touch = false;                  ///< soon
    std::optional<ClosestPlaces> closest{};  ///< of the two yarns, where there is a distinct one
  };

  [[nodiscard]] PairSight sight(const Motion& motion, ElementPair pair) const {
    return sight_of(line_.node_position(), motion, static_cast<std::size_t>(pieces_.element_of(pair.first)),
                    static_cast<std::size_t>(pieces_.element_of(pair.second)));
  }

  /// Looks at a pair for the places where it comes closest. Changes nothing.
  [[nodiscard]] PairView view(ElementPair pair) const {
    const Curve first = line_.piece_curve(pieces_, pair.first);
    const Curve second = line_.piece_curve(pieces_, pair.second);
    const double radii = radius(pair.first) + radius(pair.second);
    const double followed = kFollowed * radii;
    const Vector3 along_first = first.end - first.start;
    const Vector3 along_second = second.end - second.start;
    const ClosestPoints chords = closest_points(first.start, along_first, second.start, along_second);
    const Vector3 apart = second.start + chords.t * along_second - first.start - chords.s * along_first;
    const double least = length(apart) - bulge(first) - bulge(second) - radii;
    if (least > followed) return {.sleep = least};

    // Without a distinct closest place, what Newton's method stopped at says nothing about the rest of the pieces.
    const CurveApproach at = closest_on_curves(first, second, chords.s, chords.t);
    const double gap = length(at.between) - radii;
    if (at.is_minimum && gap > followed) return {.sleep = gap};
    PairView view{.sleep = kLookAtPairAgain * radii, .may_touch = true};
    if (at.is_minimum && is_of_yarn(pieces_, pair.first, at.s, at.slope_s, dot(at.first_slope, at.first_slope)) &&
        is_of_yarn(pieces_, pair.second, at.t, at.slope_t, dot(at.second_slope, at.second_slope))) {
      view.closest = ClosestPlaces{place(pair.first, at.s), place(pair.second, at.t), gap};
    }
    return view;
  }

  /// Takes over what a pair looks like.
  void take(ElementPair pair, const PairView& view) {
    looked_at_.pairs.push_back(pair);
    looked_at_.may_touch.push_back(view.may_touch ? 1 : 0);
    if (view.closest) add_crossing(view.closest->first, view.closest->second, view.closest->gap);
  }

  /// Notes crossings that have changed their reach so much that strips around them have to be laid anew.
  void find_changed_reach() {
    for (Crossing& crossing : contacts_.crossings) {
      const CrossingReach now = crossing.reach();
      if (is_as_laid(now, crossing.laid)) continue;
      if (crossing.laid.counts) looked_at_.changed_reach.push_back(crossing.laid);
      if (now.counts) looked_at_.changed_reach.push_back(now);
      crossing.laid = now;
    }
  }
  void dropped(const Crossing& crossing) {
    if (crossing.laid.counts) looked_at_.changed_reach.push_back(crossing.laid);
  }

  [[nodiscard]] const LookedAt& looked_at() const { return looked_at_; }

  /// Leaves two closest places within one overlap to the strips: neither has a parabola of its own.
  void leave_doubles() {
    std::vector<Crossing*> doubles;
    for (Crossing& crossing : contacts_.crossings) {
      if (!crossing.is_short) continue;
      const auto each_side = along_.elements_within(crossing.first_reach);
      crossings_on_.around(crossing.first.element, each_side, [&](std::size_t i) {
        Crossing& other = contacts_.crossings[i];
        if (&other == &crossing || !other.is_short || !stands_for(crossing, other.first, other.second)) return;
        doubles.push_back(&crossing);
        doubles.push_back(&other);
      });
    }
    for (Crossing* crossing : doubles) leave(*crossing);
  }

  /// Whether the overlap at two places is integrated about the closest places of a crossing.
  [[nodiscard]] bool is_counted(YarnPlace first, YarnPlace second) const {
    const double farthest = (kBeyondEnd * kLongOverlap + kMarginOfReach) * along_.radii(first, second);
    bool counted = false;
    crossings_on_.around(first.element, along_.elements_within(farthest), [&](std::size_t i) {
      const Crossing& crossing = contacts_.crossings[i];
      counted = counted || (crossing.is_short && stands_for(crossing, first, second));
    });
    return counted;
  }

 private:
  [[nodiscard]] double radius(std::int32_t piece) const { return pieces_.radius_of(static_cast<std::size_t>(piece)); }
  [[nodiscard]] YarnPlace place(std::int32_t piece, double on_piece) const {
    return {pieces_.element_of(piece), pieces_.place_on_element(piece, on_piece)};
  }
  [[nodiscard]] PairSize size_of(YarnPlace first, YarnPlace second) const {
    return {along_.radii(first, second), 0, elements_.length[static_cast<std::size_t>(first.element)],
            elements_.length[static_cast<std::size_t>(second.element)]};
  }
  [[nodiscard]] bool stands_for(const Crossing& crossing, YarnPlace first, YarnPlace second) const {
    return along_.near(crossing.first, first, crossing.first_reach) &&
           along_.near(crossing.second, second, crossing.second_reach);
  }
  [[nodiscard]] bool is_as_laid(const CrossingReach& now, const CrossingReach& laid) const {
    if (now.counts != laid.counts) return false;
    if (!now.counts) return true;
    const double little = kLittleChange * along_.radii(now.first, now.second);
    return along_.near(now.first, laid.first, little) && along_.near(now.second, laid.second, little) &&
           std::abs(now.along_first - laid.along_first) < little &&
           std::abs(now.along_second - laid.along_second) < little;
  }
  static void leave(Crossing& crossing) {
    crossing.is_short = false;
    crossing.now = {};
  }

  void add_crossing(YarnPlace first, YarnPlace second, double gap) {
    const double same = kSamePlace * along_.radii(first, second);
    Crossing* known = nullptr;
    crossings_on_.around(first.element, 1, [&](std::size_t i) {
      Crossing& crossing = contacts_.crossings[i];
      if (along_.near(crossing.first, first, same) && along_.near(crossing.second, second, same)) known = &crossing;
    });
    if (known == nullptr) {
      contacts_.crossings.push_back({.first = first, .second = second, .now = {.stick = memory_.near(first, second)}});
      crossings_on_.add(first.element);
      known = &contacts_.crossings.back();
    }
    known->gap = gap;
    judge(*known, first, second);
    if (!known->is_short) leave(*known);
  }

  /// Decides whether an overlap is integrated about its closest places.
  void judge(Crossing& crossing, YarnPlace first, YarnPlace second) const {
    Followed here{.first = first, .second = second};
    look(elements_, line_, here);
    const PairSize size = size_of(here.first, here.second);
    const double distance = length(here.at.between);
    const bool was_short = crossing.is_short;
    crossing.is_short = here.hessian.ss > 0 && here.hessian.tt > 0 && here.hessian.determinant() > 0;
    if (!crossing.is_short) return;
    const HalfLengths half = half_lengths(here, distance, size);
    const double squared = half.first * half.first + half.second * half.second;
    const double limit = (was_short ? kLongOverlap : kShortOverlap) * size.radii;
    const double rise = was_short ? kRiseOfShort : kRiseOfLong;
    const double to_end = (was_short ? 1.0 : kBeyondEnd) * half.first;
    crossing.is_short = squared < limit * limit && !ends_within(here.first, to_end, size.radii) &&
                        !ends_within(here.second, to_end * half.second / half.first, size.radii) &&
                        ends_where_its_parabola_does(here, half.first, rise) &&
                        ends_where_its_parabola_does(swapped(here), half.second, rise);
    crossing.first_reach = kBeyondEnd * half.first + kMarginOfReach * size.radii;
    crossing.second_reach = kBeyondEnd * half.second + kMarginOfReach * size.radii;
  }

  /// Whether the yarn ends within an overlap, or so near to it that it might before the next look.
  [[nodiscard]] bool ends_within(YarnPlace place, double half, double radii) const {
    return to_nearer_end(elements_, place) < half + kFollowed * radii;
  }

  /// Whether the gap has risen beyond the ends of the overlap as its parabola says.
  /// \param half length along the first yarn [mm]
  [[nodiscard]] bool ends_where_its_parabola_does(const Followed& closest, double half, double share) const {
    const PairSize size = size_of(closest.first, closest.second);
    const double distance = length(closest.at.between);
    const double judged = std::max(size.radii - distance, kJudgedOverlap * size.radii);
    const double rise = share * kBeyondEnd * kBeyondEnd * judged;
    const auto has_risen = [&](double side) {
      const YarnPlace aside =
          walk(elements_, {closest.first.element, closest.first.share + side * half / size.first_length});
      if (along_.distance(aside, closest.first) < half) return true;  // the yarn ends before
      const Followed nearest = follow_nearest(elements_, line_, aside, closest.second);
      return length(nearest.at.between) - distance >= rise;
    };
    return has_risen(-kBeyondEnd) && has_risen(kBeyondEnd);
  }

  const YarnElements& elements_;
  const ContactElements& pieces_;
  const Centreline& line_;
  AlongYarns along_;
  const ContactMemory& memory_;
  FollowedContacts& contacts_;
  ByElement crossings_on_;
  LookedAt looked_at_;
};

/// Follows the crossings that are asleep to where they are now.
void rouse(const YarnElements& elements, const Centreline& line, std::vector<Crossing>& crossings) {
  const AlongYarns along(elements);
  for (Crossing& crossing : crossings) {
    if (crossing.wake <= 0) continue;
    const Followed here = follow_closest(elements, line, crossing.first, crossing.second);
    crossing.first = here.first;
    crossing.second = here.second;
    crossing.gap = length(here.at.between) - along.radii(here.first, here.second);
    crossing.is_minimum = here.is_minimum;
    crossing.wake = 0;
  }
}

/// Whether a crossing has come apart or is left to strips.
bool is_over(const AlongYarns& along, const Crossing& crossing) {
  return !crossing.is_short || !crossing.is_minimum ||
         crossing.gap >= 2 * kFollowed * along.radii(crossing.first, crossing.second);
}

/// Takes out crossings that are over or have run into each other. \return those
std::vector<Crossing> drop(const YarnElements& elements, std::vector<Crossing>& crossings) {
  const AlongYarns along(elements);
  ByElement kept_on(elements.n_nodes());
  std::vector<Crossing> kept;
  std::vector<Crossing> dropped;
  for (const Crossing& crossing : crossings) {
    const double together = 0.1 * kSamePlace * along.radii(crossing.first, crossing.second);
    bool stays = !is_over(along, crossing);
    kept_on.around(crossing.first.element, 1, [&](std::size_t i) {
      stays = stays && !(along.near(kept[i].first, crossing.first, together) &&
                         along.near(kept[i].second, crossing.second, together));
    });
    if (stays) kept_on.add(crossing.first.element);
    (stays ? kept : dropped).push_back(crossing);
  }
  // In the order of the yarns, so that those that follow each other need the same nodes.
  std::stable_sort(kept.begin(), kept.end(),
                   [](const Crossing& a, const Crossing& b) { return a.first.element < b.first.element; });
  crossings = std::move(kept);
  return dropped;
}

}  // namespace

void look_for_contacts(const YarnElements& elements, const ContactElements& pieces, const Centreline& line,
                       Motion& motion, PairWatch& watch, const base::ThreadTeam& team, FollowedContacts& contacts) {
  rouse(elements, line, contacts.crossings);
  ContactMemory memory(elements, pieces, contacts);
  const std::vector<Crossing> dropped = drop(elements, contacts.crossings);
  Look look(elements, pieces, line, memory, contacts);
  for (const Crossing& crossing : dropped) look.dropped(crossing);
  std::vector<std::size_t> due;
  const double early = kLookEarly * 2 * pieces.largest_radius;
  watch.find_due(pieces, early, motion, team, due);
  std::vector<Look::PairView> views(due.size());
  const auto view = [&](std::size_t number) {
    const ElementPair pair = watch.pairs()[number];
    if (const PairWatch::Look* last = watch.last_look(number)) {
      const double left = last->length - motion_between(last->sight, look.sight(motion, pair));
      if (left > early) return Look::PairView{.sleep = left, .is_as_before = true};
    }
    return look.view(pair);
  };
  team.for_ranges(due.size(), kPairsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) views[i] = view(due[i]);
  });
  for (std::size_t i = 0; i < due.size(); ++i) {
    watch.let_sleep(pieces, motion, due[i], views[i].sleep);
    if (views[i].is_as_before) continue;
    const ElementPair pair = watch.pairs()[due[i]];
    const bool has_touched = watch.last_look(due[i]) != nullptr;
    if (views[i].may_touch || has_touched) {
      watch.note(due[i], {look.sight(motion, pair), views[i].sleep});
      look.take(pair, views[i]);
    }
  }
  watch.bound_elements(pieces, due, team, motion);
  look.leave_doubles();
  look.find_changed_reach();
  lay_strips(
      elements, pieces, line, look.looked_at(),
      [&](YarnPlace first, YarnPlace second) { return look.is_counted(first, second); }, memory, team, contacts);
  contacts.asks_for_look = false;
}

}  // namespace knitmech::contact
