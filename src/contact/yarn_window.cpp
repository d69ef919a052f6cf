#include "contact/yarn_window.h"

#include <algorithm>

namespace knitmech::contact {

namespace {

/// Adds the place at an arc length, which lies on a piece.
void add_cut(const ContactElements& elements, const model::VectorArray& position, std::size_t piece, double arc,
             WindowLine& line) {
  const double start = elements.arc_length[piece];
  const double share = (arc - start) / (elements.arc_length[piece + 1] - start);
  line.points.push_back((1 - share) * position.at(piece) + share * position.at(piece + 1));
  line.arc_length.push_back(arc);
}

}  // namespace

std::vector<YarnRange> yarn_ranges(const ContactElements& elements) {
  std::vector<YarnRange> ranges;
  for (std::size_t i = 0; i < elements.n_nodes(); ++i) {
    if (elements.exists[i] == 0) continue;
    if (!elements.has_previous(i)) ranges.push_back({elements.yarn[i], i, i});
    ranges.back().last_node = i + 1;
  }
  return ranges;
}

WindowLine cut_window(const ContactElements& elements, const YarnRange& yarn, const model::VectorArray& position,
                      ArcWindow window) {
  WindowLine line;
  const auto begin = elements.arc_length.begin() + static_cast<std::ptrdiff_t>(yarn.first_node);
  const auto end = elements.arc_length.begin() + static_cast<std::ptrdiff_t>(yarn.last_node) + 1;
  const double from = std::max(window.from, *begin);
  const double to = std::min(window.to, *(end - 1));
  if (!(from < to)) return line;
  // The piece that the window starts on: the last node at or before its start.
  auto piece = yarn.first_node + static_cast<std::size_t>(std::upper_bound(begin, end, from) - begin) - 1;
  add_cut(elements, position, piece, from, line);
  for (; elements.arc_length[piece + 1] < to; ++piece) {
    line.points.push_back(position.at(piece + 1));
    line.arc_length.push_back(elements.arc_length[piece + 1]);
  }
  add_cut(elements, position, piece, to, line);
  return line;
}

}  // namespace knitmech::contact
