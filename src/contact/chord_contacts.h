#pragma once

#include <cstdint>
#include <vector>

#include "contact/contact_points.h"
#include "contact/pair_watch.h"
#include "model/state.h"

namespace knitmech::contact {

/// Closest points of two chords that overlap.
struct ChordContact {
  std::uint64_t key = 0;  ///< see chord_key()
  ContactPoint point;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(key, point);
  }
};

/// Orders the contacts of chords and finds them again in the next step.
inline std::uint64_t chord_key(std::int32_t first, std::int32_t second) {
  return (static_cast<std::uint64_t>(first) << 32) | static_cast<std::uint64_t>(second);
}

/// Two chords that touch, or are near enough to touch soon.
struct NearChords {
  ElementPair pair{};
  double wake = 0;  ///< motion of both elements since the last search before which they cannot touch [mm]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(pair, wake);
  }
};

/// Looks at all pairs that are awake, and lists those that are near enough to touch soon (kFollowed in constants.h).
/// Replaces `near`, ascending.
void look_at_chords(const ContactElements& elements, const model::VectorArray& position, Motion& motion,
                    PairWatch& watch, std::vector<NearChords>& near);

/// Finds the contact points of a list of element pairs, on the chords: the closest points of every two chords whose
/// distance is below the sum of the radii. Replaces `found`; ascending by key; nothing remembered yet.
///
/// The distance of two chords is a continuous function of their nodes, and so is the energy of the contact: nothing
/// jumps while a yarn slides over a node. The price is that both chords at a node see a yarn that presses there, so
/// that the penalty is up to twice as stiff near nodes and one crossing may count as up to four contact points. The
/// force that the contact carries does not depend on that, only the (small) penetration does. Other finite-element
/// programs that work on the edges of the mesh do the same, which makes this centreline the one to compare them with.
/// \param near chords that are apart are left until they might touch
/// \param stiffness K of a crossing [N/mm]
void find_chord_contacts(const YarnElements& elements, const Motion& motion, const model::VectorArray& position,
                         double stiffness, std::vector<NearChords>& near, std::vector<ChordContact>& found);

/// Gives every contact the memory that it had a step before; a contact that has slid on to another chord takes that of
/// the same place on the adjacent chord of either yarn, if it pressed in nearly the same direction and is not found
/// there any more.
/// \param before, now ascending by key
void recall(const std::vector<ChordContact>& before, std::vector<ChordContact>& now);

}  // namespace knitmech::contact
