#pragma once

#include <utility>
#include <vector>

#include "contact/contact_elements.h"
#include "contact/motion.h"
#include "contact/neighbour_search.h"

namespace knitmech::contact {

/// Which of the pairs of pieces that are near each other have to be looked at.
///
/// A pair that is apart sleeps until its yarns might have come near enough to be followed (kFollowed in constants.h).
class PairWatch {
 public:
  /// Takes the pairs of elements that were searched for anew: those of before that have such an element are dropped
  /// unless they are found again. New ones are awake.
  /// \param is_due elements that were searched for, one entry per contact node
  /// \param found ascending
  void renew(const std::vector<char>& is_due, const std::vector<ElementPair>& found);
  [[nodiscard]] const std::vector<ElementPair>& pairs() const { return pairs_; }

  /// Numbers of the pairs that are awake or nearly, ascending. Replaces `due`.
  /// \param early length that a pair must still have left to sleep on [mm]
  void find_due(const ContactElements& pieces, double early, const Motion& motion, std::vector<std::size_t>& due) const;

  /// Lets a pair sleep until its yarns have come nearer to each other by a length from now on [mm].
  void let_sleep(const ContactElements& pieces, const Motion& motion, std::size_t pair, double length) {
    wakes_[pair] = motion_of(pieces, motion, pairs_[pair]) + length;
  }

  /// Bounds the motion of the elements by what is left to their pairs.
  void bound_elements(const ContactElements& pieces, Motion& motion) const;

  /// Calls look(pair) for every pair that is awake or nearly; it returns a length as for let_sleep(). Then bounds the
  /// elements.
  template <typename Look>
  void look_at_all(const ContactElements& pieces, double early, Motion& motion, const Look& look) {
    std::vector<std::size_t> due;
    find_due(pieces, early, motion, due);
    for (const std::size_t pair : due) let_sleep(pieces, motion, pair, look(pairs_[pair]));
    bound_elements(pieces, motion);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(pairs_, wakes_);
  }

 private:
  [[nodiscard]] static double motion_of(const ContactElements& pieces, const Motion& motion, ElementPair pair) {
    return motion.of(static_cast<std::size_t>(pieces.element_of(pair.first))) +
           motion.of(static_cast<std::size_t>(pieces.element_of(pair.second)));
  }

  std::vector<ElementPair> pairs_;
  std::vector<double> wakes_;  ///< motion of both elements since the search at which a pair wakes [mm]
};

}  // namespace knitmech::contact
