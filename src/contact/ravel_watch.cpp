#include "contact/ravel_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/segment_distance.h"
#include "contact/gauss_integral.h"
#include "contact/watch_constants.h"

namespace knitmech::contact {

namespace {

/// Where two lines come closest.
struct LinePlaces {
  double distance;         ///< [mm]
  double first_arc = 0;    ///< arc length of the place on the first yarn [mm]
  double second_arc = 0;   ///< on the second [mm]
  Vector3 second_place{};  ///< [mm]
};

/// Closest points of segment i of the first line and segment j of the second.
LinePlaces closest_on_segments(const WindowLine& first, std::size_t i, const WindowLine& second, std::size_t j) {
  const Vector3 u = first.points[i + 1] - first.points[i];
  const Vector3 v = second.points[j + 1] - second.points[j];
  const ClosestPoints at = closest_points(first.points[i], u, second.points[j], v);
  const Vector3 place = second.points[j] + at.t * v;
  return {length(place - first.points[i] - at.s * u),
          first.arc_length[i] + at.s * (first.arc_length[i + 1] - first.arc_length[i]),
          second.arc_length[j] + at.t * (second.arc_length[j + 1] - second.arc_length[j]), place};
}

/// At an infinite distance if one of them is empty.
LinePlaces closest_on_lines(const WindowLine& first, const WindowLine& second) {
  LinePlaces closest{std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i + 1 < first.points.size(); ++i) {
    for (std::size_t j = 0; j + 1 < second.points.size(); ++j) {
      const LinePlaces here = closest_on_segments(first, i, second, j);
      if (here.distance < closest.distance) closest = here;
    }
  }
  return closest;
}

WindowLine piece_line(const ContactElements& elements, const model::VectorArray& position, std::int32_t piece) {
  const auto i = static_cast<std::size_t>(piece);
  return {{position.at(i), position.at(i + 1)}, {elements.arc_length[i], elements.arc_length[i + 1]}};
}

/// The part of a window that is near a place.
ArcWindow around(double place, double reach, ArcWindow window) {
  return {std::max(window.from, place - reach), std::min(window.to, place + reach)};
}

/// Whether a place is not at either end of a window, but for rounding.
bool is_inside(double place, ArcWindow window) {
  const double rim = 1e-6 * (window.to - window.from);
  return place > window.from + rim && place < window.to - rim;
}

}  // namespace

RavelWatch::RavelWatch(std::shared_ptr<const ContactElements> elements)
    : elements_(std::move(elements)), ranges_(yarn_ranges(*elements_)), tail_at_(elements_->n_nodes(), kNoTail) {
  for (std::size_t r = 0; r < ranges_.size(); ++r) {
    const YarnRange& range = ranges_[r];
    range_of_yarn_.resize(static_cast<std::size_t>(range.yarn) + 1);
    range_of_yarn_.back() = r;
    const double whole = elements_->arc_length[range.last_node] - elements_->arc_length[range.first_node];
    const double tail = std::min(2 * kTail * elements_->radius_of(range.first_node), 0.5 * whole);
    add_tail(r, YarnEnd::first_node, tail);
    add_tail(r, YarnEnd::last_node, tail);
  }
}

void RavelWatch::add_tail(std::size_t range, YarnEnd end, double length) {
  const bool first = end == YarnEnd::first_node;
  const double end_arc = elements_->arc_length[first ? ranges_[range].first_node : ranges_[range].last_node];
  const ArcWindow window = first ? ArcWindow{end_arc, end_arc + length} : ArcWindow{end_arc - length, end_arc};
  for (std::size_t i = ranges_[range].first_node; i < ranges_[range].last_node; ++i) {
    // A piece that two tails share belongs to that which has its middle.
    const double middle = 0.5 * (elements_->arc_length[i] + elements_->arc_length[i + 1]);
    const bool within = elements_->arc_length[i] < window.to && elements_->arc_length[i + 1] > window.from;
    if (within && (tail_at_[i] == kNoTail || middle > window.from)) tail_at_[i] = first ? kFirstTail : kLastTail;
  }
  tails_.push_back({range, end, window, end_arc});
}

std::vector<RavelEvent> RavelWatch::update(const model::VectorArray& position, const std::vector<ElementPair>& pairs) {
  std::vector<RavelEvent> events;
  follow_held(position, events);
  hold_new(position, pairs);
  return events;
}

void RavelWatch::follow_held(const model::VectorArray& position, std::vector<RavelEvent>& events) {
  std::vector<HeldCrossing> before = std::move(held_);
  held_.clear();
  for (HeldCrossing& crossing : before) {
    look(position, crossing.now);
    if (is_known(crossing.now)) continue;  // two places have become one
    if (std::abs(crossing.now.integral) > std::abs(crossing.largest_integral) && is_held(crossing.now)) {
      crossing.largest_integral = crossing.now.integral;
    }
    if (crossing.now.integral / crossing.largest_integral > kOffShare) {
      held_.push_back(crossing);
    } else if (end_is_there(crossing.now)) {
      events.push_back(event_of(crossing.now));
      gone_.push_back(crossing.now);
    }
  }
}

void RavelWatch::hold_new(const model::VectorArray& position, const std::vector<ElementPair>& pairs) {
  std::vector<TailApproach> found;
  for (const ElementPair pair : pairs) {
    add_approach(position, pair.first, pair.second, found);
    add_approach(position, pair.second, pair.first, found);
  }
  for (TailApproach& approach : found) {
    if (look(position, approach) && is_held(approach) && !is_known(approach))
      held_.push_back({approach, approach.integral});
  }
}

/// Of all pairs of pieces near the same place, the nearest stays.
void RavelWatch::add_approach(const model::VectorArray& position, std::int32_t tail_piece, std::int32_t other_piece,
                              std::vector<TailApproach>& found) const {
  const std::uint8_t tail = tail_at_[static_cast<std::size_t>(tail_piece)];
  if (tail == kNoTail) return;
  const LinePlaces at =
      closest_on_lines(piece_line(*elements_, position, tail_piece), piece_line(*elements_, position, other_piece));
  TailApproach approach{2 * range_of(tail_piece) + (tail == kLastTail ? 1 : 0), range_of(other_piece), at.second_arc,
                        at.distance};
  approach.sticks_out = std::abs(at.first_arc - tails_[approach.tail].end_arc);
  if (is_own_yarn(approach) && loop_length(approach) <= 0) return;  // the other piece is the one nearer to the end
  if (is_known(approach)) return;
  for (TailApproach& before : found) {
    if (!is_same(before, approach, kOtherHalfWindow)) continue;
    if (approach.distance < before.distance) before = approach;
    return;
  }
  found.push_back(approach);
}

/// Moves the places to where the yarns are nearest now, not far from where they were, and measures there.
/// \return whether the yarns are nearest there, and not still nearer further on
bool RavelWatch::look(const model::VectorArray& position, TailApproach& approach) const {
  const std::size_t yarn = tails_[approach.tail].range;
  const auto cut = [&](std::size_t range, ArcWindow window) {
    return cut_window(*elements_, ranges_[range], position, window);
  };
  const double step = kPlaceStep * diameter(approach);
  const Windows before = windows(approach);
  const ArcWindow on_tail = around(place_on_tail(approach), step, before.tail);
  const ArcWindow on_other = around(approach.arc_length, step, before.other);
  const LinePlaces at = closest_on_lines(cut(yarn, on_tail), cut(approach.other, on_other));
  approach.arc_length = at.second_arc;
  approach.place = at.second_place;
  approach.distance = at.distance;
  approach.sticks_out = std::abs(at.first_arc - tails_[approach.tail].end_arc);
  const Windows now = windows(approach);
  approach.integral = gauss_integral(cut(yarn, now.tail).points, cut(approach.other, now.other).points);
  return is_inside(at.first_arc, on_tail) && is_inside(at.second_arc, on_other);
}

double RavelWatch::place_on_tail(const TailApproach& approach) const {
  const Tail& tail = tails_[approach.tail];
  return tail.end == YarnEnd::first_node ? tail.end_arc + approach.sticks_out : tail.end_arc - approach.sticks_out;
}

RavelWatch::Windows RavelWatch::windows(const TailApproach& approach) const {
  const Tail& tail = tails_[approach.tail];
  const double half = kOtherHalfWindow * diameter(approach);
  Windows windows{tail.window, {approach.arc_length - half, approach.arc_length + half}};
  if (!is_own_yarn(approach)) return windows;
  const double quarter = 0.25 * loop_length(approach);
  if (tail.end == YarnEnd::first_node) {
    windows.tail.to = std::min(windows.tail.to, place_on_tail(approach) + quarter);
    windows.other.from = std::max(windows.other.from, approach.arc_length - quarter);
  } else {
    windows.tail.from = std::max(windows.tail.from, place_on_tail(approach) - quarter);
    windows.other.to = std::min(windows.other.to, approach.arc_length + quarter);
  }
  return windows;
}

bool RavelWatch::is_own_yarn(const TailApproach& approach) const {
  return approach.other == tails_[approach.tail].range;
}

/// Length of yarn between both places of an approach of a yarn to itself [mm].
double RavelWatch::loop_length(const TailApproach& approach) const {
  const Tail& tail = tails_[approach.tail];
  const double from_end =
      tail.end == YarnEnd::first_node ? approach.arc_length - tail.end_arc : tail.end_arc - approach.arc_length;
  return from_end - approach.sticks_out;
}

bool RavelWatch::is_held(const TailApproach& approach) const {
  const double d = diameter(approach);
  return approach.sticks_out >= kHeldTail * d && approach.distance < kAtYarn * d &&
         std::abs(approach.integral) >= kHeldIntegral;
}

bool RavelWatch::end_is_there(const TailApproach& approach) const {
  const double d = diameter(approach);
  return approach.sticks_out < kHeldTail * d && approach.distance < kAtYarn * d;
}

bool RavelWatch::is_known(const TailApproach& approach) const {
  const auto near_held = [&](const HeldCrossing& held) { return is_same(held.now, approach, kOtherHalfWindow); };
  const auto near_gone = [&](const TailApproach& gone) { return is_same(gone, approach, kSameEvent); };
  return std::any_of(held_.begin(), held_.end(), near_held) || std::any_of(gone_.begin(), gone_.end(), near_gone);
}

/// \param reach along the other yarn [D]
bool RavelWatch::is_same(const TailApproach& a, const TailApproach& b, double reach) const {
  return a.tail == b.tail && a.other == b.other && std::abs(a.arc_length - b.arc_length) < reach * diameter(a);
}

double RavelWatch::diameter(const TailApproach& approach) const {
  return elements_->radius_of(ranges_[tails_[approach.tail].range].first_node) +
         elements_->radius_of(ranges_[approach.other].first_node);
}

RavelEvent RavelWatch::event_of(const TailApproach& approach) const {
  const Tail& tail = tails_[approach.tail];
  return {ranges_[tail.range].yarn, tail.end, ranges_[approach.other].yarn, approach.arc_length, approach.place};
}

}  // namespace knitmech::contact
