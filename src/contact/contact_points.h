#pragma once

#include <cstdint>
#include <vector>

#include "contact/contact_elements.h"
#include "contact/neighbour_search.h"
#include "model/state.h"

namespace knitmech::contact {

/// One place where two yarns press on each other: a place on each centreline, as shares of the way along an element.
struct ContactPoint {
  std::uint64_t key;           ///< see contact_key()
  std::int32_t first, second;  ///< elements, first < second
  double place_first;          ///< on the first element, in [0, 1]
  double place_second;         ///< on the second
  Vector3 normal;              ///< unit vector from the first centreline to the second
  double penetration;          ///< sum of the radii minus least centreline distance [mm], > 0
  double load;                 ///< normal force [N]
  double tangent;              ///< derivative of the load by the penetration [N/mm]
  double energy;               ///< stored in the normal law [mJ]
};

/// Which contact point of a pair: the whole of a short overlap, the halves of it that the two yarns count where it
/// reaches over the end of a piece, or samples of a long one.
inline constexpr unsigned kWholeCrossing = 0;
inline constexpr unsigned kFirstHalf = 1;
inline constexpr unsigned kSecondHalf = 2;
inline constexpr unsigned kFirstSample = 3;

/// Orders contact points and finds them again in the next step.
inline std::uint64_t contact_key(std::int32_t first, std::int32_t second, unsigned sample = kWholeCrossing) {
  return (static_cast<std::uint64_t>(first) << 36) | (static_cast<std::uint64_t>(second) << 8) | sample;
}
inline unsigned sample_of(std::uint64_t key) {
  return static_cast<unsigned>(key & 0xff);
}

/// When a pair of elements has to be looked at again, on a clock that counts motion instead of time: no point of a
/// centreline has moved by more than the clock has advanced. Two yarns a gap g apart cannot touch before it has
/// advanced by g / 2.
struct PairClock {
  double now = 0;               ///< [mm]
  std::vector<double> look_at;  ///< [mm], one entry per pair

  [[nodiscard]] bool may_sleep(std::size_t pair) const { return now < look_at[pair]; }
  void sleep(std::size_t pair, double gap) { look_at[pair] = now + 0.5 * gap; }
};

/// Finds the contact points of a list of element pairs, on the chords: the closest points of every two chords whose
/// distance is below the sum of the radii. Replaces `found`; ascending by key.
///
/// The distance of two chords is a continuous function of their nodes, and so is the energy of the contact: nothing
/// jumps while a yarn slides over a node. The price is that both chords at a node see a yarn that presses there, so
/// that the penalty is up to twice as stiff near nodes and one crossing may count as up to four contact points. The
/// force that the contact carries does not depend on that, only the (small) penetration does. Other finite-element
/// programs that work on the edges of the mesh do the same, which makes this centreline the one to compare them with.
void find_chord_contacts(const ContactElements& elements, const std::vector<ElementPair>& pairs,
                         const model::VectorArray& position, PairClock& clock, std::vector<ContactPoint>& found);

}  // namespace knitmech::contact
