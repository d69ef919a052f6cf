#include "contact/crossing_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/segment_distance.h"
#include "contact/watch_constants.h"
#include "contact/yarn_window.h"

namespace knitmech::contact {

namespace {

/// A direction that no fabric has.
constexpr Vector3 kOffsetDirection{0.5377, 0.3119, 0.7833};

/// A pass of one piece through another.
struct Pass {
  ElementPair pair;
  int count;      ///< with its sign
  Vector3 place;  ///< [mm]
};

bool are_neighbours(const Pass& a, const Pass& b) {
  return std::abs(a.pair.first - b.pair.first) <= 1 && std::abs(a.pair.second - b.pair.second) <= 1;
}

/// Takes one pass and all that hang together with it, pair by neighbouring pair, out of a list.
std::vector<Pass> take_group(std::vector<Pass>& passes) {
  std::vector<Pass> group{passes.back()};
  passes.pop_back();
  for (std::size_t i = 0; i < group.size(); ++i) {
    const Pass member = group[i];
    const auto apart = std::stable_partition(passes.begin(), passes.end(),
                                             [&](const Pass& other) { return !are_neighbours(member, other); });
    group.insert(group.end(), apart, passes.end());
    passes.erase(apart, passes.end());
  }
  return group;
}

/// One loss for every group of passes that do not cancel.
std::vector<CrossingLoss> losses_of(std::vector<Pass> passes) {
  std::vector<CrossingLoss> losses;
  while (!passes.empty()) {
    const std::vector<Pass> group = take_group(passes);
    int sum = 0;
    for (const Pass& pass : group) sum += pass.count;
    if (sum == 0) continue;
    const auto pass = std::find_if(group.begin(), group.end(), [&](const Pass& p) { return p.count * sum > 0; });
    losses.push_back({pass->pair.first, pass->pair.second, pass->place});
  }
  return losses;
}

/// Where two segments come closest: their distance and the point halfway between them [mm].
struct Meeting {
  double distance;
  Vector3 place;
};

Meeting meeting(const Segment& a, const Segment& b) {
  const Vector3 u = a.end - a.start;
  const Vector3 v = b.end - b.start;
  const ClosestPoints at = closest_points(a.start, u, b.start, v);
  const Vector3 on_a = a.start + at.s * u;
  const Vector3 on_b = b.start + at.t * v;
  return {length(on_b - on_a), 0.5 * (on_a + on_b)};
}

/// Where two pieces passed each other, taken from that end of the motion at which they were nearer.
Vector3 place_of_pass(const MovedSegment& a, const MovedSegment& b) {
  const Meeting before = meeting(a.before, b.before);
  const Meeting now = meeting(a.now, b.now);
  return before.distance < now.distance ? before.place : now.place;
}

Segment segment(std::int32_t piece, const model::VectorArray& position) {
  const auto i = static_cast<std::size_t>(piece);
  return {position.at(i), position.at(i + 1)};
}

/// The furthest that a point of a segment has moved as seen from a point of the other one [mm]: from end to end.
double relative_motion(const MovedSegment& a, const MovedSegment& b) {
  const Vector3 a_start = a.now.start - a.before.start;
  const Vector3 a_end = a.now.end - a.before.end;
  const Vector3 b_start = b.now.start - b.before.start;
  const Vector3 b_end = b.now.end - b.before.end;
  return std::max({length(b_start - a_start), length(b_end - a_start), length(b_start - a_end), length(b_end - a_end)});
}

}  // namespace

CrossingWatch::CrossingWatch(std::shared_ptr<const ContactElements> elements)
    : elements_(std::move(elements)),
      offset_(kOffset * 2 * elements_->largest_radius * kOffsetDirection),
      ends_(elements_) {
  for (const YarnRange& yarn : yarn_ranges(*elements_)) {
    const double uncounted = kUncountedEnd * elements_->radius_of(yarn.first_node);
    counted_.resize(static_cast<std::size_t>(yarn.yarn) + 1, {0, 0});
    counted_.back() = {elements_->arc_length[yarn.first_node] + uncounted,
                       elements_->arc_length[yarn.last_node] - uncounted};
  }
}

CrossingWatch::CountedPart CrossingWatch::counted_part(std::int32_t piece) const {
  const auto i = static_cast<std::size_t>(piece);
  const ArcWindow& window = counted_[static_cast<std::size_t>(elements_->yarn[i])];
  const double start = elements_->arc_length[i];
  const double size = elements_->arc_length[i + 1] - start;
  return {std::max(0.0, (window.from - start) / size), std::min(1.0, (window.to - start) / size)};
}

Segment CrossingWatch::counted_segment(std::int32_t piece, const model::VectorArray& position) const {
  const CountedPart part = counted_part(piece);
  const Segment whole = segment(piece, position);
  return {(1 - part.from) * whole.start + part.from * whole.end, (1 - part.to) * whole.start + part.to * whole.end};
}

CrossingReport CrossingWatch::update(const model::VectorArray& position, const std::vector<ElementPair>& pairs,
                                     double motion, const base::ThreadTeam& team) {
  CrossingReport report;
  report.lost = losses(position);
  report.ravelled = ends_.update(position, pairs);
  remember(position, pairs, motion + length(offset_), team);
  return report;
}

std::vector<CrossingLoss> CrossingWatch::losses(const model::VectorArray& position) const {
  std::vector<Pass> found;
  for (const NearPair& near : near_) {
    const MovedSegment a{near.first, counted_segment(near.pair.first, position)};
    const MovedSegment b{near.second, counted_segment(near.pair.second, position)};
    if (near.distance > relative_motion(a, b) + length(offset_)) continue;
    const int count = passes(a, b, offset_);
    if (count != 0) found.push_back({near.pair, count, place_of_pass(a, b)});
  }
  return losses_of(std::move(found));
}

void CrossingWatch::remember(const model::VectorArray& position, const std::vector<ElementPair>& pairs, double reach,
                             const base::ThreadTeam& team) {
  constexpr std::size_t kAtOnce = 256;
  std::vector<double> distances(pairs.size());
  team.for_ranges(pairs.size(), kAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      distances[p] = meeting(segment(pairs[p].first, position), segment(pairs[p].second, position)).distance;
    }
  });
  near_.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const ElementPair pair = pairs[p];
    if (distances[p] > reach || !counted_part(pair.first).is_any() || !counted_part(pair.second).is_any()) continue;
    near_.push_back(
        {pair, distances[p], counted_segment(pair.first, position), counted_segment(pair.second, position)});
  }
}

}  // namespace knitmech::contact
