#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/left_out.h"
#include "base/thread_team.h"
#include "contact/contact_elements.h"
#include "contact/motion.h"
#include "contact/neighbour_search.h"
#include "contact/pair_sight.h"

namespace knitmech::contact {

/// Which of the pairs of pieces that are near each other have to be looked at.
///
/// A pair that is apart sleeps until its yarns might have come near enough to be followed (kFollowed in constants.h).
/// What is left to a pair bounds the motion of its two elements, each by half of it. So only the pairs of elements that
/// have reached their bound can be due, and a look costs as much as there is around these: the end of a yarn that whips
/// about has its own pairs looked at in every other step, and the fabric sleeps on.
class PairWatch {
 public:
  /// Takes the pairs of elements that were searched for anew: those of before that have such an element are dropped
  /// unless they are found again. New ones are awake.
  /// \param is_due elements that were searched for, one entry per contact node
  /// \param found ascending
  void renew(const std::vector<char>& is_due, const std::vector<ElementPair>& found);
  [[nodiscard]] const std::vector<ElementPair>& pairs() const { return pairs_; }

  /// Has all pairs and elements seen to at the next look: to be called when the limits of their motion have changed.
  void wake_all() { sees_to_all_ = true; }

  /// Numbers of the pairs that are awake or nearly, ascending. Replaces `due`.
  /// \param early length that a pair must still have left to sleep on [mm]
  void find_due(const ContactElements& pieces, double early, const Motion& motion, const base::ThreadTeam& team,
                std::vector<std::size_t>& due);

  /// Lets a pair sleep until its yarns have come nearer to each other by a length from now on [mm].
  void let_sleep(const ContactElements& pieces, const Motion& motion, std::size_t pair, double length) {
    wakes_[pair] = motion_of(pieces, motion, pair) + length;
  }

  /// What a pair was like when it was last looked at.
  struct Look {
    PairSight sight;
    double length = 0;  ///< by which its yarns might come nearer from then on [mm]

    template <class Archive>
    void serialize(Archive& archive) {
      archive(sight, length);
    }
  };
  /// Null if none was noted.
  [[nodiscard]] const Look* last_look(std::size_t pair) const {
    return look_at_[pair] == kNone ? nullptr : &looks_[look_at_[pair]];
  }
  void note(std::size_t pair, const Look& look) {
    if (look_at_[pair] == kNone) {
      look_at_[pair] = static_cast<std::uint32_t>(looks_.size());
      looks_.push_back(look);
    } else {
      looks_[look_at_[pair]] = look;
    }
  }

  /// Bounds the motion of the elements by what is left to their pairs, after those that were due have been looked at.
  void bound_elements(const ContactElements& pieces, const std::vector<std::size_t>& due, const base::ThreadTeam& team,
                      Motion& motion);

  /// Calls look(pair) for every pair that is awake or nearly; it returns a length as for let_sleep(). Then bounds the
  /// elements.
  template <typename Call>
  void look_at_all(const ContactElements& pieces, double early, Motion& motion, const Call& look,
                   const base::ThreadTeam& team = base::ThreadTeam(1)) {
    std::vector<std::size_t> due;
    find_due(pieces, early, motion, team, due);
    for (const std::size_t pair : due) let_sleep(pieces, motion, pair, look(pairs_[pair]));
    bound_elements(pieces, due, team, motion);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(pairs_, wakes_, look_at_, looks_, sees_to_all_, base::left_out(first_on_, on_element_, at_bound_, found_));
  }

 private:
  [[nodiscard]] double motion_of(const ContactElements& pieces, const Motion& motion, std::size_t pair) const {
    return motion.of(static_cast<std::size_t>(pieces.element_of(pairs_[pair].first))) +
           motion.of(static_cast<std::size_t>(pieces.element_of(pairs_[pair].second)));
  }
  /// What is left to a pair [mm].
  [[nodiscard]] double left_to(const ContactElements& pieces, const Motion& motion, std::size_t pair) const {
    return wakes_[pair] - motion_of(pieces, motion, pair);
  }
  void reserve(std::size_t n_pairs, std::size_t n_looks);
  void shrink_to_fit();
  void add(ElementPair pair);
  void add(const PairWatch& other, std::size_t pair);
  void sort_by_elements(const ContactElements& pieces, std::size_t n_elements);
  template <typename Call>
  void for_pairs_on(std::size_t element, const Call& call) const {
    for (std::uint32_t i = first_on_[element]; i < first_on_[element + 1]; ++i) call(std::size_t{on_element_[i]});
  }
  void bound_all(const ContactElements& pieces, const base::ThreadTeam& team, Motion& motion) const;

  std::vector<ElementPair> pairs_;
  std::vector<double> wakes_;  ///< motion of both elements since the start at which a pair wakes [mm]
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> look_at_;  ///< number of the last look at each pair
  std::vector<Look> looks_;
  bool sees_to_all_ = true;
  /// Pairs on each element: entries of on_element_ from first_on_ of the element to that of the next one. None until
  /// they are needed.
  std::vector<std::uint32_t> first_on_, on_element_;
  std::vector<std::size_t> at_bound_;            ///< elements that have nearly reached their bound
  std::vector<std::vector<std::size_t>> found_;  ///< by each thread
};

}  // namespace knitmech::contact
