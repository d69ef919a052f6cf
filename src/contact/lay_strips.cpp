#include "contact/lay_strips.h"

#include <algorithm>
#include <utility>

#include "contact/constants.h"
#include "contact/placed_points.h"
#include "contact/touch_finder.h"

namespace knitmech::contact {

namespace {

/// Lays the strips of one overlap.
class Layout {
 public:
  Layout(const ContactElements& pieces, const CountedElsewhere& is_counted, const ContactMemory& memory)
      : pieces_(pieces), is_counted_(is_counted), memory_(memory) {}

  void lay(Overlap& overlap) {
    overlap.rows.clear();
    overlap.spans.clear();
    overlap.laid.clear();
    overlap.loads.clear();
    find_uncounted(overlap);
    set_rows(overlap);
    for (std::size_t i = 0; i < uncounted_.size();) {
      std::size_t end = i + 1;
      while (end < uncounted_.size() && follows(uncounted_[end - 1], uncounted_[end])) ++end;
      add_strip(i, end, overlap);
      i = end;
    }
  }

 private:
  [[nodiscard]] YarnPlace place(CutPiece of, double part) const {
    return {pieces_.element_of(of.piece), pieces_.place_on_element(of.piece, part / of.n)};
  }

  /// The touches of an overlap that no crossing counts.
  void find_uncounted(const Overlap& overlap) {
    uncounted_.clear();
    for (const Touch& touch : overlap.touches) {
      const YarnPlace at = place(overlap.strips, touch.strip + 0.5);
      const bool on_second = overlap.strips.piece > touch.cells.piece;
      bool goes_on = false;
      for (std::int32_t c = touch.first; c <= touch.last; ++c) {
        const YarnPlace there = place(touch.cells, c + 0.5);
        const bool counted = on_second ? is_counted_(there, at) : is_counted_(at, there);
        if (!counted && goes_on) uncounted_.back().last = c;
        if (!counted && !goes_on) uncounted_.push_back({touch.strip, touch.cells, c, c});
        goes_on = !counted;
      }
    }
  }

  void set_rows(Overlap& overlap) const {
    const auto find = [&](CutPiece cells) {
      return std::find_if(overlap.rows.begin(), overlap.rows.end(),
                          [&](const CellRow& row) { return row.cells == cells; });
    };
    for (const Touch& touch : uncounted_) {
      const auto row = find(touch.cells);
      if (row == overlap.rows.end()) {
        overlap.rows.push_back({touch.cells, touch.first, touch.last, 0});
      } else {
        row->first = std::min(row->first, touch.first);
        row->last = std::max(row->last, touch.last);
      }
    }
    std::sort(overlap.rows.begin(), overlap.rows.end(),
              [](const CellRow& a, const CellRow& b) { return a.cells < b.cells; });
    std::size_t n_points = 0;
    for (CellRow& row : overlap.rows) {
      row.first_point = static_cast<std::int32_t>(n_points);
      n_points += rounded_up(static_cast<std::size_t>(row.n_points()));
    }
  }

  /// Whether the cells of a touch go on where those of the touch before end, for the same strip.
  [[nodiscard]] bool follows(const Touch& before, const Touch& next) const {
    return next.strip == before.strip && next.cells.piece == before.cells.piece + 1 &&
           pieces_.has_next(static_cast<std::size_t>(before.cells.piece)) && before.last == before.cells.n - 1 &&
           next.first == 0;
  }

  void add_strip(std::size_t from, std::size_t to, Overlap& overlap) const {
    Strip strip;
    strip.number = uncounted_[from].strip;
    strip.at = place(overlap.strips, strip.number + 0.5);
    strip.first_span = static_cast<std::int32_t>(overlap.spans.size());
    strip.n_spans = static_cast<std::int32_t>(to - from);
    for (std::size_t i = from; i < to; ++i) {
      const Touch& touch = uncounted_[i];
      std::int32_t r = 0;
      while (!(overlap.rows[static_cast<std::size_t>(r)].cells == touch.cells)) ++r;
      const CellRow& row = overlap.rows[static_cast<std::size_t>(r)];
      overlap.spans.push_back({r, row.first_point + 2 * (touch.first - row.first), touch.last - touch.first + 1});
    }
    const Touch& amid = uncounted_[(from + to - 1) / 2];
    strip.other = place(amid.cells, 0.5 * (amid.first + amid.last + 1));
    remember(strip);
    overlap.laid.push_back(strip);
  }

  /// Gives a strip what one that lay at the same place knew, or what a contact nearby held on to.
  void remember(Strip& strip) const {
    if (const Strip* known = memory_.strip(strip.number, strip.at, strip.other)) {
      strip.other = known->other;
      strip.now = known->now;
    } else {
      strip.now.stick = memory_.near(strip.at, strip.other);
    }
  }

  const ContactElements& pieces_;
  const CountedElsewhere& is_counted_;
  const ContactMemory& memory_;
  std::vector<Touch> uncounted_;
};

/// Whether a touch is one with a piece.
auto is_of(std::int32_t piece) {
  return [piece](const Touch& touch) { return touch.cells.piece == piece; };
}

/// Brings overlaps up to date, and knows which of them have to be laid anew.
class Overlaps {
 public:
  Overlaps(const YarnElements& elements, const ContactElements& pieces, std::vector<Overlap>& overlaps)
      : along_(elements), pieces_(pieces), overlaps_(overlaps), is_dirty_(overlaps.size(), 0) {}

  /// Whether the second piece of a pair was the one with the strips.
  [[nodiscard]] bool is_on_second(ElementPair pair) const {
    for (std::size_t i = first_on(pair.second); i < overlaps_.size() && overlaps_[i].strips.piece == pair.second; ++i) {
      const std::vector<Touch>& touches = overlaps_[i].touches;
      if (std::any_of(touches.begin(), touches.end(), is_of(pair.first))) return true;
    }
    return false;
  }

  void replace(ElementPair pair, const PairTouches& found) {
    drop(pair.first, pair.second, found);
    drop(pair.second, pair.first, found);
    if (!found.touches.empty()) add(found);
  }

  /// Marks what lies within the reach of a crossing.
  void mark(const CrossingReach& reach) {
    mark(reach.first, reach.along_first);
    mark(reach.second, reach.along_second);
  }

  void lay_anew(const CountedElsewhere& is_counted, ContactMemory& memory) {
    Layout layout(pieces_, is_counted, memory);
    for (std::size_t i = 0; i < overlaps_.size(); ++i) {
      if (is_dirty_[i] == 0) continue;
      memory.take_strips_of(i, overlaps_[i]);
      layout.lay(overlaps_[i]);
    }
    std::erase_if(overlaps_, [](const Overlap& overlap) { return overlap.touches.empty(); });
  }

 private:
  [[nodiscard]] std::size_t first_on(std::int32_t piece) const {
    const auto at = std::lower_bound(overlaps_.begin(), overlaps_.end(), CutPiece{piece, 0}, is_before);
    return static_cast<std::size_t>(at - overlaps_.begin());
  }

  /// Drops what the strips of a piece touched of another, unless it is what was found.
  void drop(std::int32_t piece, std::int32_t other, const PairTouches& found) {
    for (std::size_t i = first_on(piece); i < overlaps_.size() && overlaps_[i].strips.piece == piece; ++i) {
      std::vector<Touch>& touches = overlaps_[i].touches;
      if (!found.touches.empty() && overlaps_[i].strips == found.strips && is_same(touches, other, found)) continue;
      if (std::erase_if(touches, is_of(other)) > 0) is_dirty_[i] = 1;
    }
  }

  [[nodiscard]] static bool is_same(const std::vector<Touch>& touches, std::int32_t other, const PairTouches& found) {
    auto next = found.touches.begin();
    for (const Touch& touch : touches) {
      if (touch.cells.piece != other) continue;
      if (next == found.touches.end() || !(touch == *next)) return false;
      ++next;
    }
    return next == found.touches.end();
  }

  void add(const PairTouches& found) {
    const auto at = std::lower_bound(overlaps_.begin(), overlaps_.end(), found.strips, is_before);
    const std::ptrdiff_t i = at - overlaps_.begin();
    if (at == overlaps_.end() || !(at->strips == found.strips)) {
      overlaps_.insert(at, Overlap{})->strips = found.strips;
      is_dirty_.insert(is_dirty_.begin() + i, 0);
    }
    std::vector<Touch>& touches = overlaps_[static_cast<std::size_t>(i)].touches;
    if (std::any_of(touches.begin(), touches.end(), is_of(found.touches.front().cells.piece))) return;  // the same
    const auto old_end = static_cast<std::ptrdiff_t>(touches.size());
    touches.insert(touches.end(), found.touches.begin(), found.touches.end());
    std::inplace_merge(touches.begin(), touches.begin() + old_end, touches.end());
    is_dirty_[static_cast<std::size_t>(i)] = 1;
  }

  void mark(YarnPlace place, double reach) {
    const std::int32_t each_side = along_.elements_within(reach);
    const std::int32_t m = pieces_.pieces_per_element;
    for (std::size_t i = first_on((place.element - each_side) * m);
         i < overlaps_.size() && overlaps_[i].strips.piece < (place.element + each_side + 1) * m; ++i) {
      is_dirty_[i] = 1;
    }
  }

  AlongYarns along_;
  const ContactElements& pieces_;
  std::vector<Overlap>& overlaps_;
  std::vector<char> is_dirty_;
};

}  // namespace

void lay_strips(const YarnElements& elements, const ContactElements& pieces, const Centreline& line,
                const LookedAt& looked_at, const CountedElsewhere& is_counted, ContactMemory& memory,
                const base::ThreadTeam& team, FollowedContacts& contacts) {
  Overlaps overlaps(elements, pieces, contacts.overlaps);
  std::vector<PairTouches> found(looked_at.pairs.size());
  team.for_ranges(found.size(), kPairsAtOnce, [&](std::size_t begin, std::size_t end) {
    TouchFinder finder(elements, pieces, line);
    for (std::size_t p = begin; p < end; ++p) {
      const ElementPair pair = looked_at.pairs[p];
      if (looked_at.may_touch[p] != 0) finder.find(pair, overlaps.is_on_second(pair), found[p]);
    }
  });
  for (std::size_t p = 0; p < found.size(); ++p) overlaps.replace(looked_at.pairs[p], found[p]);
  for (const CrossingReach& reach : looked_at.changed_reach) overlaps.mark(reach);
  overlaps.lay_anew(is_counted, memory);
}

}  // namespace knitmech::contact
