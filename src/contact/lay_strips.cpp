#include "contact/lay_strips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "base/vectorise.h"
#include "contact/constants.h"

namespace knitmech::contact {

namespace {

/// How far a new place may be from the one whose memory it takes [sums of the radii].
constexpr double kNearby = 1.0;

/// Rise of the squared distance along a yarn, see rise_along(), that is small beside that of yarns that cross [-].
constexpr double kEvenRise = 0.1;

/// Points of a cut piece, as far as its parts are needed.
struct PointRange {
  CutPiece of;
  int first, last;
  std::size_t block = 0, first_point = 0;
};

/// The ranges of all cut pieces that are needed.
class NeededPoints {
 public:
  void need(CutPiece of, int first, int last) {
    const auto [at, is_new] = number_.try_emplace(key(of), ranges_.size());
    if (is_new) ranges_.push_back({of, first, last});
    PointRange& range = ranges_[at->second];
    range.first = std::min(range.first, first);
    range.last = std::max(range.last, last);
  }
  [[nodiscard]] std::vector<PointRange>& ranges() { return ranges_; }
  [[nodiscard]] const PointRange& of(CutPiece piece) const { return ranges_[number_.at(key(piece))]; }

 private:
  static std::uint64_t key(CutPiece of) {
    return (static_cast<std::uint64_t>(of.piece) << 32) | static_cast<std::uint64_t>(of.n);
  }
  std::unordered_map<std::uint64_t, std::size_t> number_;
  std::vector<PointRange> ranges_;
};

/// Points as separate components.
struct PointList {
  std::vector<double> x, y, z;
  void clear() {
    x.clear();
    y.clear();
    z.clear();
  }
  void add(Vector3 v) {
    x.push_back(v.x);
    y.push_back(v.y);
    z.push_back(v.z);
  }
  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] Vector3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Squared distances of points from a point, and the least of each before and now.
KNITMECH_VECTORISE void squared_distances(Vector3 from, std::size_t n, const double* x, const double* y,
                                          const double* z, double* squared, double* least) {
#pragma omp simd
  for (std::size_t j = 0; j < n; ++j) {
    const double dx = x[j] - from.x;
    const double dy = y[j] - from.y;
    const double dz = z[j] - from.z;
    squared[j] = dx * dx + dy * dy + dz * dz;
    least[j] = squared[j] < least[j] ? squared[j] : least[j];
  }
}

bool is_less(ElementPair a, ElementPair b) {
  return a.first < b.first || (a.first == b.first && a.second < b.second);
}

/// Finds the strips and cells of pairs of pieces that may touch.
class TouchFinder {
 public:
  TouchFinder(const YarnElements& elements, const ContactElements& pieces, const Centreline& line)
      : elements_(elements), pieces_(pieces), line_(line) {}

  /// \param was_on_second kept where both yarns are alike \param touches the pair's are appended
  PairTouches find(ElementPair pair, bool was_on_second, std::vector<Touch>& touches) {
    PairTouches found{pair, was_on_second, touches.size(), 0};
    const double radii = radius(pair.first) + radius(pair.second);
    middles(cut(pair.first, kStripLength * radii), first_points_);
    middles(cut(pair.second, kStripLength * radii), second_points_);
    const double reach = radii * (1 + kFollowed) + 0.5 * kStripLength * radii;
    if (find_profiles() > reach * reach) return found;
    found.on_second = cuts_second(pair, was_on_second);
    if (found.on_second) {
      add_touches(pair.second, pair.first, second_points_, second_profile_, touches);
    } else {
      add_touches(pair.first, pair.second, first_points_, first_profile_, touches);
    }
    found.n_touches = touches.size() - found.first_touch;
    return found;
  }

 private:
  [[nodiscard]] double radius(std::int32_t piece) const { return pieces_.radius[static_cast<std::size_t>(piece)]; }
  [[nodiscard]] double length_of(std::int32_t piece) const {
    return elements_.length[static_cast<std::size_t>(pieces_.element_of(piece))] / pieces_.pieces_per_element;
  }
  [[nodiscard]] CutPiece cut(std::int32_t piece, double size) const {
    return {piece, std::clamp(static_cast<int>(std::ceil(length_of(piece) / size)), 1, kMostOnPiece)};
  }
  [[nodiscard]] YarnPlace place(std::int32_t piece, double on_piece) const {
    return {pieces_.element_of(piece), pieces_.place_on_element(piece, on_piece)};
  }

  void middles(CutPiece of, PointList& points) const {
    const Curve curve = line_.curve(static_cast<std::size_t>(pieces_.element_of(of.piece)));
    points.clear();
    for (int i = 0; i < of.n; ++i) {
      points.add(combine(curve, hermite(pieces_.place_on_element(of.piece, (i + 0.5) / of.n))));
    }
  }

  /// Squared distance of every point of each piece from the nearest one of the other. \return the least of all
  double find_profiles() {
    first_profile_.clear();
    second_profile_.assign(second_points_.size(), 1e300);
    squared_.resize(second_points_.size());
    for (std::size_t i = 0; i < first_points_.size(); ++i) {
      squared_distances(first_points_.at(i), second_points_.size(), second_points_.x.data(), second_points_.y.data(),
                        second_points_.z.data(), squared_.data(), second_profile_.data());
      first_profile_.push_back(*std::min_element(squared_.begin(), squared_.end()));
    }
    return *std::min_element(first_profile_.begin(), first_profile_.end());
  }

  /// Whether the second piece is the one to be cut into strips: that along which the distance changes less.
  [[nodiscard]] bool cuts_second(ElementPair pair, bool was_on_second) const {
    const double first = rise_along(first_profile_, length_of(pair.first)) + kEvenRise;
    const double second = rise_along(second_profile_, length_of(pair.second)) + kEvenRise;
    if (second > kSidesAlike * first) return false;
    if (first > kSidesAlike * second) return true;
    return was_on_second;
  }

  /// How the squared distance rises along a piece, from where it is least to where it is greatest, over the square of
  /// the way [-]: 1 for straight yarns that cross at a right angle, 0 where they lie side by side.
  [[nodiscard]] static double rise_along(const std::vector<double>& profile, double length) {
    const auto least = std::min_element(profile.begin(), profile.end());
    const auto most = std::max_element(profile.begin(), profile.end());
    const double way = static_cast<double>(most - least) * length / static_cast<double>(profile.size());
    return way == 0 ? 0 : (*most - *least) / (way * way);
  }

  void add_touches(std::int32_t piece, std::int32_t other, const PointList& strip_points,
                   const std::vector<double>& profile, std::vector<Touch>& touches) {
    const double radii = radius(piece) + radius(other);
    const CutPiece strips{piece, static_cast<int>(strip_points.size())};
    const CutPiece cells = cut(other, kCellLength * radii);
    const Curve curve = line_.curve(static_cast<std::size_t>(pieces_.element_of(other)));
    const double reach = radii * (1 + kFollowed);
    const double far = reach + 0.5 * kStripLength * radii;
    cell_points_.clear();
    for (int j = 0; j <= 2 * cells.n; ++j) {
      cell_points_.add(combine(curve, hermite(pieces_.place_on_element(other, 0.5 * j / cells.n))));
    }
    squared_.resize(cell_points_.size());
    least_.assign(cell_points_.size(), 0.0);
    for (int i = 0; i < strips.n; ++i) {
      if (profile[static_cast<std::size_t>(i)] > far * far) continue;
      squared_distances(strip_points.at(static_cast<std::size_t>(i)), cell_points_.size(), cell_points_.x.data(),
                        cell_points_.y.data(), cell_points_.z.data(), squared_.data(), least_.data());
      const YarnPlace at = place(piece, (i + 0.5) / strips.n);
      const std::size_t before = touches.size();
      for (int c = 0; c < cells.n; ++c) {
        const std::size_t p = 2 * static_cast<std::size_t>(c);
        if (std::min({squared_[p], squared_[p + 1], squared_[p + 2]}) >= reach * reach) continue;
        const YarnPlace there = place(other, (c + 0.5) / cells.n);
        if (too_near(at, there, radii)) continue;
        if (touches.size() > before && touches.back().last == c - 1) {
          touches.back().last = c;
        } else {
          touches.push_back({strips, i, cells, c, c});
        }
      }
    }
  }

  /// Whether two places of one yarn are so near along it that they cannot touch.
  [[nodiscard]] bool too_near(YarnPlace a, YarnPlace b, double radii) const {
    return elements_.yarn[static_cast<std::size_t>(a.element)] == elements_.yarn[static_cast<std::size_t>(b.element)] &&
           std::abs(arc_of(elements_, a) - arc_of(elements_, b)) < kSelfContactArc * std::numbers::pi * radii;
  }

  const YarnElements& elements_;
  const ContactElements& pieces_;
  const Centreline& line_;
  PointList first_points_, second_points_, cell_points_;
  std::vector<double> first_profile_, second_profile_, squared_, least_;
};

/// Brings the touches of the pairs that were looked at up to date.
void find_touches(const YarnElements& elements, const ContactElements& pieces, const Centreline& line,
                  const PairsLookedAt& looked_at, FollowedContacts& contacts) {
  TouchFinder finder(elements, pieces, line);
  std::vector<PairTouches> pairs;
  std::vector<Touch> touches;
  auto old = contacts.pairs.cbegin();
  const auto keep_until = [&](ElementPair pair) {
    for (; old != contacts.pairs.cend() && is_less(old->pair, pair); ++old) {
      pairs.push_back(*old);
      pairs.back().first_touch = touches.size();
      const auto from = contacts.touches.cbegin() + static_cast<std::ptrdiff_t>(old->first_touch);
      touches.insert(touches.end(), from, from + static_cast<std::ptrdiff_t>(old->n_touches));
    }
  };
  auto touching = looked_at.touching.cbegin();
  for (const ElementPair pair : looked_at.all) {
    keep_until(pair);
    bool was_on_second = false;
    if (old != contacts.pairs.cend() && !is_less(pair, old->pair)) was_on_second = (old++)->on_second;
    if (touching == looked_at.touching.cend() || is_less(pair, *touching)) continue;
    ++touching;
    const PairTouches found = finder.find(pair, was_on_second, touches);
    if (found.n_touches > 0) pairs.push_back(found);
  }
  keep_until({std::numeric_limits<std::int32_t>::max(), 0});
  contacts.pairs = std::move(pairs);
  contacts.touches = std::move(touches);
}

/// Makes strips out of touches.
class Layout {
 public:
  Layout(const YarnElements& elements, const ContactElements& pieces) : elements_(elements), pieces_(pieces) {}

  /// Takes the touches that no crossing counts.
  void take(const FollowedContacts& contacts, const CountedElsewhere& is_counted) {
    for (const PairTouches& pair : contacts.pairs) {
      for (std::size_t t = pair.first_touch; t < pair.first_touch + pair.n_touches; ++t) {
        take(contacts.touches[t], pair.on_second, is_counted);
      }
    }
    std::sort(touches_.begin(), touches_.end());
  }

  void lay(FollowedContacts& contacts) const {
    contacts.strips.clear();
    contacts.spans.clear();
    contacts.points.clear();
    NeededPoints strips;
    NeededPoints cells;
    for (const Touch& touch : touches_) {
      strips.need(touch.strips, touch.strip, touch.strip);
      cells.need(touch.cells, touch.first, touch.last);
    }
    place_middles(strips.ranges(), contacts.points);
    place_cells(cells.ranges(), contacts.points);
    for (std::size_t i = 0; i < touches_.size();) {
      std::size_t end = i + 1;
      while (end < touches_.size() && follows(touches_[end - 1], touches_[end])) ++end;
      add_strip(i, end, strips, cells, contacts);
      i = end;
    }
  }

 private:
  [[nodiscard]] double length_of(std::int32_t piece) const {
    return elements_.length[static_cast<std::size_t>(pieces_.element_of(piece))] / pieces_.pieces_per_element;
  }
  [[nodiscard]] YarnPlace place(CutPiece of, double part) const {
    return {pieces_.element_of(of.piece), pieces_.place_on_element(of.piece, part / of.n)};
  }

  void take(const Touch& touch, bool on_second, const CountedElsewhere& is_counted) {
    const YarnPlace at = place(touch.strips, touch.strip + 0.5);
    const std::size_t before = touches_.size();
    for (std::int32_t c = touch.first; c <= touch.last; ++c) {
      const YarnPlace there = place(touch.cells, c + 0.5);
      if (on_second ? is_counted(there, at) : is_counted(at, there)) continue;
      if (touches_.size() > before && touches_.back().last == c - 1) {
        touches_.back().last = c;
      } else {
        touches_.push_back({touch.strips, touch.strip, touch.cells, c, c});
      }
    }
  }

  /// Whether the cells of a touch go on where those of the touch before end, for the same strip.
  [[nodiscard]] bool follows(const Touch& before, const Touch& next) const {
    return next.strips == before.strips && next.strip == before.strip && next.cells.piece == before.cells.piece + 1 &&
           pieces_.has_next(static_cast<std::size_t>(before.cells.piece)) && before.last == before.cells.n - 1 &&
           next.first == 0;
  }

  void place_middles(std::vector<PointRange>& ranges, PlacedPoints& points) const {
    std::vector<double> shares;
    for (PointRange& range : ranges) {
      shares.clear();
      for (int i = range.first; i <= range.last; ++i) {
        shares.push_back(pieces_.place_on_element(range.of.piece, (i + 0.5) / range.of.n));
      }
      range.block = points.n_blocks();
      range.first_point = points.add(pieces_.element_of(range.of.piece), shares);
    }
  }

  /// Two points to a cell, its start and its middle, and the end of the last.
  void place_cells(std::vector<PointRange>& ranges, PlacedPoints& points) const {
    std::vector<double> shares;
    for (PointRange& range : ranges) {
      shares.clear();
      for (int j = 2 * range.first; j <= 2 * range.last + 2; ++j) {
        shares.push_back(pieces_.place_on_element(range.of.piece, 0.5 * j / range.of.n));
      }
      range.block = points.n_blocks();
      range.first_point = points.add(pieces_.element_of(range.of.piece), shares);
    }
  }

  void add_strip(std::size_t from, std::size_t to, const NeededPoints& strips, const NeededPoints& cells,
                 FollowedContacts& contacts) const {
    const Touch& first = touches_[from];
    const PointRange& middles = strips.of(first.strips);
    Strip strip;
    strip.at = place(first.strips, first.strip + 0.5);
    strip.block = middles.block;
    strip.point = middles.first_point + static_cast<std::size_t>(first.strip - middles.first);
    strip.length = length_of(first.strips.piece) / first.strips.n;
    strip.first_span = contacts.spans.size();
    for (std::size_t i = from; i < to; ++i) {
      const Touch& touch = touches_[i];
      const PointRange& range = cells.of(touch.cells);
      contacts.spans.push_back(
          {range.block, range.first_point + 2 * static_cast<std::size_t>(touch.first - range.first),
           static_cast<std::size_t>(touch.last - touch.first + 1), length_of(touch.cells.piece) / touch.cells.n});
    }
    strip.n_spans = to - from;
    const Touch& amid = touches_[(from + to - 1) / 2];
    strip.other = place(amid.cells, 0.5 * (amid.first + amid.last + 1));
    contacts.strips.push_back(strip);
  }

  const YarnElements& elements_;
  const ContactElements& pieces_;
  std::vector<Touch> touches_;
};

/// Gives new strips what those that lay at the same places knew, and others what contacts nearby held on to.
void remember(const ContactMemory& memory, std::vector<Strip>& strips) {
  for (Strip& strip : strips) {
    if (const Strip* known = memory.strip(strip.at, strip.other)) {
      strip.other = known->other;
      strip.wake = known->wake;
      strip.now = known->now;
    } else {
      strip.now.stick = memory.near(strip.at, strip.other);
    }
  }
}

}  // namespace

ContactMemory::ContactMemory(const YarnElements& elements, const FollowedContacts& before)
    : along_(elements), before_(before), held_on_(elements.n_nodes()), strips_on_(elements.n_nodes()) {
  const auto hold = [&](YarnPlace first, YarnPlace second, const SlipMemory& stick) {
    if (dot(stick.normal, stick.normal) == 0) return;
    held_.push_back({first, second, stick});
    held_.push_back({second, first, flipped(stick)});
    held_on_.add(first.element);
    held_on_.add(second.element);
  };
  for (const Crossing& crossing : before.crossings) hold(crossing.first, crossing.second, crossing.now.stick);
  for (const Strip& strip : before.strips) {
    hold(strip.at, strip.other, strip.now.stick);
    strips_on_.add(strip.at.element);
  }
}

SlipMemory ContactMemory::near(YarnPlace first, YarnPlace second) const {
  double least = kNearby * along_.radii(first, second);
  SlipMemory memory;
  held_on_.around(first.element, along_.elements_within(least), [&](std::size_t i) {
    const Held& held = held_[i];
    if (!along_.near(held.first, first, least) || !along_.near(held.second, second, least)) return;
    least = std::max(along_.distance(held.first, first), along_.distance(held.second, second));
    memory = held.stick;
  });
  memory.normal = {};
  return memory;
}

const Strip* ContactMemory::strip(YarnPlace at, YarnPlace other) const {
  const Strip* known = nullptr;
  double least = kNearby * along_.radii(at, other);
  strips_on_.around(at.element, 0, [&](std::size_t i) {
    const Strip& old = before_.strips[i];
    if (old.at.share != at.share || !along_.near(old.other, other, least)) return;
    least = along_.distance(old.other, other);
    known = &old;
  });
  return known;
}

void lay_strips(const YarnElements& elements, const ContactElements& pieces, const Centreline& line,
                const PairsLookedAt& looked_at, const CountedElsewhere& is_counted, const ContactMemory& memory,
                FollowedContacts& contacts) {
  find_touches(elements, pieces, line, looked_at, contacts);
  Layout layout(elements, pieces);
  layout.take(contacts, is_counted);
  layout.lay(contacts);
  remember(memory, contacts.strips);
}

}  // namespace knitmech::contact
