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

  /// Calls look(pair) for every pair that is awake or nearly; it returns a length by which the yarns may come nearer to
  /// each other until the pair has to be looked at again [mm]. Bounds the motion of the elements by what is left to
  /// their pairs.
  /// \param early length that a pair must still have left to sleep on [mm]
  template <typename Look>
  void look_at_all(const ContactElements& pieces, double early, Motion& motion, const Look& look) {
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const auto first = static_cast<std::size_t>(pieces.element_of(pairs_[p].first));
      const auto second = static_cast<std::size_t>(pieces.element_of(pairs_[p].second));
      const double moved = motion.of(first) + motion.of(second);
      if (!(moved + early < wakes_[p])) wakes_[p] = moved + look(pairs_[p]);
      motion.bound(first, second, wakes_[p] - moved);
    }
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(pairs_, wakes_);
  }

 private:
  std::vector<ElementPair> pairs_;
  std::vector<double> wakes_;  ///< motion of both elements since the search at which a pair wakes [mm]
};

}  // namespace knitmech::contact
