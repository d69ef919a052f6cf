#include "contact/look_for_contacts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/segment_distance.h"
#include "contact/closest_places.h"
#include "contact/constants.h"
#include "contact/curve_distance.h"
#include "contact/overlap_shares.h"
#include "contact/yarn_end.h"

namespace knitmech::contact {

namespace {

/// Distance from the end of a piece within which a place lies on it [share of the piece].
constexpr double kOnEnd = 1e-6;

/// Two places that were followed to the same point differ by no more than this [sums of the radii].
constexpr double kSamePlace = 0.02;

/// How far a new place may be from the one whose memory it takes [sums of the radii].
constexpr double kNearby = 1.0;

/// Beyond this many half lengths of its parabola an overlap must have ended; up to it the gap must have risen by this
/// share of what the parabola says, for an overlap that was integrated about its closest places or by samples so far.
constexpr double kBeyondEnd = 1.25;
constexpr double kRiseOfShort = 0.7;
constexpr double kRiseOfLong = 0.85;

/// Numbers of what lies on each element.
class ByElement {
 public:
  explicit ByElement(std::size_t n_elements) : first_(n_elements, -1) {}
  void add(std::int32_t element) {
    next_.push_back(first_[static_cast<std::size_t>(element)]);
    first_[static_cast<std::size_t>(element)] = static_cast<std::int32_t>(next_.size()) - 1;
  }
  /// Calls for every number on the elements around one.
  template <typename Call>
  void around(std::int32_t element, std::int32_t each_side, const Call& call) const {
    const std::int32_t last = std::min(element + each_side, static_cast<std::int32_t>(first_.size()) - 1);
    for (std::int32_t e = std::max(element - each_side, 0); e <= last; ++e) {
      for (std::int32_t i = first_[static_cast<std::size_t>(e)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
        call(static_cast<std::size_t>(i));
      }
    }
  }

 private:
  std::vector<std::int32_t> first_, next_;
};

/// Distances and neighbourhoods along the yarns.
struct AlongYarns {
  const YarnElements& elements;
  double shortest = std::numeric_limits<double>::max();  ///< element [mm]

  explicit AlongYarns(const YarnElements& of) : elements(of) {
    for (std::size_t i = 0; i < of.n_nodes(); ++i) {
      if (of.exists[i] != 0) shortest = std::min(shortest, of.length[i]);
    }
  }
  [[nodiscard]] double radii(YarnPlace a, YarnPlace b) const {
    return elements.radius[static_cast<std::size_t>(a.element)] + elements.radius[static_cast<std::size_t>(b.element)];
  }
  [[nodiscard]] bool near(YarnPlace a, YarnPlace b, double reach) const {
    return elements.yarn[static_cast<std::size_t>(a.element)] == elements.yarn[static_cast<std::size_t>(b.element)] &&
           distance(a, b) < reach;
  }
  /// Of two places on one yarn.
  [[nodiscard]] double distance(YarnPlace a, YarnPlace b) const {
    return std::abs(arc_of(elements, a) - arc_of(elements, b));
  }
  /// How many elements to look at on each side for what is within reach.
  [[nodiscard]] std::int32_t elements_within(double reach) const {
    return static_cast<std::int32_t>(std::min(reach / shortest, 1e6)) + 1;
  }
};

/// Whether a closest place on a piece is one of the whole yarn: not if it is held at an end beyond which the yarn comes
/// nearer. \param slope derivative of half the squared distance by the place [mm^2]  \param bend its second derivative
bool is_of_yarn(const ContactElements& pieces, std::int32_t piece, double place, double slope, double bend) {
  const auto at = static_cast<std::size_t>(piece);
  if (place >= 1 - kOnEnd && slope < -kOnEnd * bend) return !pieces.has_next(at);
  if (place <= kOnEnd && slope > kOnEnd * bend) return !pieces.has_previous(at);
  return true;
}

class Look {
 public:
  Look(const YarnElements& elements, const ContactElements& pieces, const Centreline& line, FollowedContacts& contacts)
      : elements_(elements),
        pieces_(pieces),
        line_(line),
        along_(elements),
        before_(contacts),
        contacts_(contacts),
        crossings_on_(elements.n_nodes()) {
    for (const Crossing& crossing : contacts.crossings) crossings_on_.add(crossing.first.element);
  }

  /// Looks at a pair for the places where it comes closest. \return motion of both yarns until the next look [mm]
  double at(ElementPair pair) {
    const Curve first = line_.piece_curve(pieces_, pair.first);
    const Curve second = line_.piece_curve(pieces_, pair.second);
    const double radii = radius(pair.first) + radius(pair.second);
    const double followed = kFollowed * radii;
    const Vector3 along_first = first.end - first.start;
    const Vector3 along_second = second.end - second.start;
    const ClosestPoints chords = closest_points(first.start, along_first, second.start, along_second);
    const Vector3 apart = second.start + chords.t * along_second - first.start - chords.s * along_first;
    const double least = length(apart) - bulge(first) - bulge(second) - radii;
    if (least > followed) return least - followed;

    // Without a distinct closest place, what Newton's method stopped at says nothing about the rest of the pieces.
    const CurveApproach at = closest_on_curves(first, second, chords.s, chords.t);
    const double gap = length(at.between) - radii;
    if (at.is_minimum && gap > followed) return gap - followed;
    if (at.is_minimum && is_of_yarn(pieces_, pair.first, at.s, at.slope_s, dot(at.first_slope, at.first_slope)) &&
        is_of_yarn(pieces_, pair.second, at.t, at.slope_t, dot(at.second_slope, at.second_slope))) {
      add_crossing(place(pair.first, at.s), place(pair.second, at.t), gap);
    }
    touching_.push_back(pair);
    return kLookAgain * radii;
  }

  /// Looks at all pairs that touch for overlaps to be sampled; drops samples where closest places count the overlap.
  void sample() {
    std::erase_if(contacts_.samples,
                  [&](const Sample& sample) { return is_counted(sample.at, sample.other, sample.on_second); });
    ByElement samples_on(elements_.n_nodes());
    for (const Sample& sample : contacts_.samples) samples_on.add(sample.at.element);
    for (const ElementPair pair : touching_) {
      add_samples(pair.first, pair.second, false, samples_on);
      add_samples(pair.second, pair.first, true, samples_on);
    }
  }

 private:
  [[nodiscard]] double radius(std::int32_t piece) const { return pieces_.radius[static_cast<std::size_t>(piece)]; }
  [[nodiscard]] YarnPlace place(std::int32_t piece, double on_piece) const {
    return {pieces_.element_of(piece), pieces_.place_on_element(piece, on_piece)};
  }
  [[nodiscard]] PairSize size_of(YarnPlace first, YarnPlace second) const {
    return {along_.radii(first, second), 0, elements_.length[static_cast<std::size_t>(first.element)],
            elements_.length[static_cast<std::size_t>(second.element)]};
  }

  void add_crossing(YarnPlace first, YarnPlace second, double gap) {
    const double same = kSamePlace * along_.radii(first, second);
    Crossing* known = nullptr;
    crossings_on_.around(first.element, 1, [&](std::size_t i) {
      Crossing& crossing = contacts_.crossings[i];
      if (along_.near(crossing.first, first, same) && along_.near(crossing.second, second, same)) known = &crossing;
    });
    if (known == nullptr) {
      contacts_.crossings.push_back({.first = first, .second = second, .now = {.stick = memory_near(first, second)}});
      crossings_on_.add(first.element);
      known = &contacts_.crossings.back();
    }
    known->gap = gap;
    judge(*known, first, second);
    if (!known->is_short) known->now = {};
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
    crossing.is_short = squared < limit * limit && ends_where_its_parabola_does(here, half.first, rise) &&
                        ends_where_its_parabola_does(swapped(here), half.second, rise);
    crossing.first_reach = kBeyondEnd * half.first + kSampleSpacing * size.radii;
    crossing.second_reach = kBeyondEnd * half.second + kSampleSpacing * size.radii;
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

  /// Whether the overlap at two places is integrated about the closest places of a crossing.
  /// \param on_second the sampled place is that on the second yarn
  [[nodiscard]] bool is_counted(YarnPlace sampled, YarnPlace other, bool on_second) const {
    const YarnPlace first = on_second ? other : sampled;
    const YarnPlace second = on_second ? sampled : other;
    const double farthest = (kBeyondEnd * kLongOverlap + kSampleSpacing) * along_.radii(first, second);
    bool counted = false;
    crossings_on_.around(first.element, along_.elements_within(farthest), [&](std::size_t i) {
      const Crossing& crossing = contacts_.crossings[i];
      counted = counted ||
                (crossing.is_short && crossing.gap < 0 && along_.near(crossing.first, first, crossing.first_reach) &&
                 along_.near(crossing.second, second, crossing.second_reach));
    });
    return counted;
  }

  void add_samples(std::int32_t piece, std::int32_t other_piece, bool on_second, ByElement& samples_on) {
    const double radii = radius(piece) + radius(other_piece);
    const std::int32_t element = pieces_.element_of(piece);
    const double size = elements_.length[static_cast<std::size_t>(element)];
    const int n = std::clamp(static_cast<int>(std::ceil(size / (kSampleSpacing * radii))), 1, kMostSamples);
    const Curve curve = line_.curve(static_cast<std::size_t>(element));
    const Curve other = line_.piece_curve(pieces_, other_piece);
    const Vector3 along = other.end - other.start;
    const double reach = radii * (1 + kLookAgain) + bulge(other);
    const int from = static_cast<int>(std::ceil(n * pieces_.place_on_element(piece, 0) - 0.5));
    const int to = static_cast<int>(std::ceil(n * pieces_.place_on_element(piece, 1) - 0.5));
    for (int i = from; i < to; ++i) {
      const YarnPlace at{element, (i + 0.5) / n};
      const Vector3 here = combine(curve, hermite(at.share));
      const double start = closest_on_segment(here, other.start, along);
      const Vector3 to_chord = other.start + start * along - here;
      if (dot(to_chord, to_chord) >= reach * reach || is_counted(at, place(other_piece, start), on_second)) continue;
      add_sample({.at = at, .other = place(other_piece, start), .length = size / n, .on_second = on_second},
                 samples_on);
    }
  }

  void add_sample(Sample sample, ByElement& samples_on) {
    const Followed nearest = follow_nearest(elements_, line_, sample.at, sample.other);
    const PairSize size = size_of(nearest.first, nearest.second);
    const double distance = length(nearest.at.between);
    if (!nearest.is_minimum || distance > size.radii * (1 + kLookAgain) || nearest.hessian.tt <= 0) return;
    sample.other = nearest.second;
    sample.gap = distance - size.radii;
    sample.share = sample_share(nearest, distance, size);
    Sample* known = nullptr;
    samples_on.around(sample.at.element, 0, [&](std::size_t i) {
      Sample& other = contacts_.samples[i];
      if (other.at.share == sample.at.share && along_.near(other.other, sample.other, 4 * kSamePlace * size.radii)) {
        known = &other;
      }
    });
    if (known != nullptr) {
      known->share = sample.share;
      return;
    }
    if (sample.share <= 0 || is_counted(sample.at, sample.other, sample.on_second)) return;
    sample.now.stick = sample.on_second ? memory_near(sample.other, sample.at) : memory_near(sample.at, sample.other);
    contacts_.samples.push_back(sample);
    samples_on.add(sample.at.element);
  }

  /// Memory of the nearest place that was followed before this look and holds on to something.
  [[nodiscard]] SlipMemory memory_near(YarnPlace first, YarnPlace second) const {
    double least = kNearby * along_.radii(first, second);
    SlipMemory memory;
    const auto consider = [&](YarnPlace a, YarnPlace b, const SlipMemory& stick) {
      if (dot(stick.normal, stick.normal) == 0 || !along_.near(a, first, least) || !along_.near(b, second, least)) {
        return;
      }
      least = std::max(along_.distance(a, first), along_.distance(b, second));
      memory = stick;
    };
    for (const Crossing& crossing : before_.crossings) consider(crossing.first, crossing.second, crossing.now.stick);
    for (const Sample& sample : before_.samples) {
      consider(sample.on_second ? sample.other : sample.at, sample.on_second ? sample.at : sample.other,
               sample.now.stick);
    }
    memory.normal = {};
    return memory;
  }

  const YarnElements& elements_;
  const ContactElements& pieces_;
  const Centreline& line_;
  AlongYarns along_;
  FollowedContacts before_;
  FollowedContacts& contacts_;
  ByElement crossings_on_;
  std::vector<ElementPair> touching_;
};

/// Drops what has come apart, crossings that have run into each other, and those that samples count.
void drop(const YarnElements& elements, FollowedContacts& contacts) {
  const AlongYarns along(elements);
  ByElement kept_on(elements.n_nodes());
  std::vector<Crossing> kept;
  for (const Crossing& crossing : contacts.crossings) {
    const double radii = along.radii(crossing.first, crossing.second);
    const double together = 0.1 * kSamePlace * radii;
    bool stays = crossing.is_short && crossing.is_minimum && crossing.gap < 2 * kFollowed * radii;
    kept_on.around(crossing.first.element, 1, [&](std::size_t i) {
      stays = stays && !(along.near(kept[i].first, crossing.first, together) &&
                         along.near(kept[i].second, crossing.second, together));
    });
    if (!stays) continue;
    kept_on.add(crossing.first.element);
    kept.push_back(crossing);
  }
  contacts.crossings = std::move(kept);
  std::erase_if(contacts.samples, [&](const Sample& sample) {
    return !sample.is_minimum || sample.share <= 0 || sample.gap > 2 * kFollowed * along.radii(sample.at, sample.other);
  });
}

}  // namespace

void look_for_contacts(const YarnElements& elements, const ContactElements& pieces, const Centreline& line,
                       const Motion& motion, PairWatch& watch, FollowedContacts& contacts) {
  drop(elements, contacts);
  Look look(elements, pieces, line, contacts);
  watch.look_at_all(pieces, motion, [&](ElementPair pair) { return look.at(pair); });
  look.sample();
}

}  // namespace knitmech::contact
