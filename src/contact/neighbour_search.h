#pragma once

#include <cstdint>
#include <vector>

#include "base/thread_team.h"
#include "contact/contact_elements.h"
#include "model/state.h"

namespace knitmech::contact {

/// Two elements that may come into contact, first < second.
struct ElementPair {
  std::int32_t first, second;
  bool operator==(const ElementPair&) const = default;
  bool operator<(const ElementPair& other) const {
    return first < other.first || (first == other.first && second < other.second);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(first, second);
  }
};

/// What a search took.
struct SearchCost {
  std::int64_t compared = 0;  ///< pairs of elements of the same or of adjacent cells
};

/// Pairs of elements nearer than the sum of their radii plus a skin of which at least one is due, in ascending order
/// (first, then second).
///
/// Elements that are too near along the same yarn are left out (kSelfContactArc). Elements are sorted by the cell of a
/// uniform grid that their middle lies in, and those that are due are compared with those of the same and the adjacent
/// cells. So the cost is linear in the number of elements, whatever the shape of the fabric, as long as it is nowhere
/// denser and no element longer.
/// \param bulge how far the centreline may leave the chords of the pieces of each element [mm], one entry per node of
/// the model; 0 for chords
/// \param skin [mm]
/// \param is_due one entry per contact node; empty: all
/// \param cost set if given
[[nodiscard]] std::vector<ElementPair> find_neighbours(const ContactElements& elements,
                                                       const model::VectorArray& position,
                                                       const std::vector<double>& bulge, double skin,
                                                       const std::vector<char>& is_due = {}, SearchCost* cost = nullptr,
                                                       const base::ThreadTeam& team = base::ThreadTeam(1));

/// Whether two elements of one yarn are so near along the arc that they cannot touch.
[[nodiscard]] bool too_near_along_yarn(const ContactElements& elements, std::size_t first, std::size_t second);

}  // namespace knitmech::contact
