#pragma once

#include <cstdint>
#include <vector>

#include "contact/contact_elements.h"
#include "contact/neighbour_search.h"
#include "model/state.h"

namespace knitmech::contact {

/// One place where two yarns press on each other: a point on each centreline, as shares of the way along an element.
/// The same shares weigh the nodes when velocities are taken from them and forces given to them.
struct ContactPoint {
  std::uint64_t key;           ///< see contact_key()
  std::int32_t first, second;  ///< elements, first < second
  double place_first;          ///< share of the way along the first element, in [0, 1]
  double place_second;         ///< the same on the second
  Vector3 normal;              ///< unit vector from the first centreline to the second
  double penetration;          ///< sum of the radii minus centreline distance [mm], > 0
  double radii;                ///< sum of the radii [mm]
  double stiffness;            ///< K of the normal law [N/mm]
};

/// Orders contact points and finds them again in the next step.
inline std::uint64_t contact_key(std::int32_t first, std::int32_t second) {
  return (static_cast<std::uint64_t>(first) << 32) | static_cast<std::uint64_t>(second);
}

/// Finds the contact points of a list of element pairs, on the chords: the closest points of every two chords whose
/// distance is below the sum of the radii. Replaces `found`; ascending by key.
///
/// The distance of two chords is a continuous function of their nodes, and so is the energy of the contact: nothing
/// jumps while a yarn slides over a node. The price is that both chords at a node see a yarn that presses there, so
/// that the penalty is up to twice as stiff near nodes and one crossing may count as up to four contact points. The
/// force that the contact carries does not depend on that, only the (small) penetration does. Other finite-element
/// programs that work on the edges of the mesh do the same, which makes this centreline the one to compare them with.
void find_contact_points(const ContactElements& elements, const std::vector<ElementPair>& pairs,
                         const model::VectorArray& position, std::vector<ContactPoint>& found);

}  // namespace knitmech::contact
