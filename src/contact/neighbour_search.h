#pragma once

#include <cstdint>
#include <vector>

#include "contact/contact_elements.h"
#include "model/state.h"

namespace knitmech::contact {

/// Two elements that may come into contact, first < second.
struct ElementPair {
  std::int32_t first, second;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(first, second);
  }
};

/// Pairs of elements nearer than the sum of their radii plus a skin, in ascending order (first, then second).
///
/// Elements that are too near along the same yarn are left out (kSelfContactArc). Elements are sorted by the cell of a
/// uniform grid that their middle lies in, and compared with those of the same and the adjacent cells; the cost is
/// linear in the number of elements for a fabric of even density.
/// \param bulge how far the centreline may leave each element's chord [mm], one entry per node; 0 for chords
/// \param skin [mm]
[[nodiscard]] std::vector<ElementPair> find_neighbours(const ContactElements& elements,
                                                       const model::VectorArray& position,
                                                       const std::vector<double>& bulge, double skin);

/// Whether two elements of one yarn are so near along the arc that they cannot touch.
[[nodiscard]] bool too_near_along_yarn(const ContactElements& elements, std::size_t first, std::size_t second);

}  // namespace knitmech::contact
