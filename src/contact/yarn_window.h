#pragma once

#include <cstdint>
#include <vector>

#include "contact/contact_elements.h"
#include "model/state.h"

namespace knitmech::contact {

/// The contact nodes of one yarn: piece i joins node i to node i + 1, first_node <= i < last_node.
struct YarnRange {
  std::int32_t yarn;
  std::size_t first_node, last_node;
};

/// One entry per yarn that has pieces, in ascending order.
[[nodiscard]] std::vector<YarnRange> yarn_ranges(const ContactElements& elements);

/// A stretch of a yarn, by its arc length along the stress-free yarn from the first node [mm].
struct ArcWindow {
  double from, to;
};

/// A stretch of a yarn as a polyline: the contact nodes within it, and the points where it is cut. Empty for a window
/// without length.
struct WindowLine {
  std::vector<Vector3> points;     ///< [mm]
  std::vector<double> arc_length;  ///< of the points [mm]
};

/// Cuts a window out of a yarn. What lies beyond the yarn's ends is left out.
[[nodiscard]] WindowLine cut_window(const ContactElements& elements, const YarnRange& yarn,
                                    const model::VectorArray& position, ArcWindow window);

}  // namespace knitmech::contact
