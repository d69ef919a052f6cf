#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/left_out.h"
#include "base/thread_team.h"
#include "contact/contact_points.h"
#include "contact/contact_step.h"
#include "contact/element_load.h"
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
                    PairWatch& watch, const base::ThreadTeam& team, std::vector<NearChords>& near);

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
                         double stiffness, std::span<NearChords> near, std::vector<ChordContact>& found);

/// Gives every contact the memory that it had a step before; a contact that has slid on to another chord takes that of
/// the same place on the adjacent chord of either yarn, if it pressed in nearly the same direction and is not found
/// there any more.
/// \param before, now ascending by key
void recall(const std::vector<ChordContact>& before, std::vector<ChordContact>& now);

/// The forces of contacts on chords, from step to step.
class ChordForces {
 public:
  /// Adds normal and friction forces to the nodes; the same to the last bit for any number of threads.
  ContactStep add(const StepOfContacts& step, const base::ThreadTeam& team, std::vector<NearChords>& near,
                  model::NodalLoads& loads);

  /// Those of the last step, ascending by key.
  [[nodiscard]] const std::vector<ChordContact>& contacts() const { return contacts_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(contacts_, base::left_out(before_, found_, on_elements_, done_));
  }

 private:
  void find(const StepOfContacts& step, const base::ThreadTeam& team, std::vector<NearChords>& near);

  std::vector<ChordContact> contacts_, before_;
  std::vector<std::vector<ChordContact>> found_;  ///< by the shares of the threads
  std::vector<ElementLoad> on_elements_;          ///< two for each contact
  std::vector<ContactStep> done_;                 ///< by the shares of the threads
};

}  // namespace knitmech::contact
