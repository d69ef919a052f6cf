#include "contact/pair_watch.h"

#include <limits>

namespace knitmech::contact {

void PairWatch::renew(const std::vector<char>& is_due, const std::vector<ElementPair>& found) {
  std::vector<ElementPair> pairs;
  std::vector<double> wakes;
  pairs.reserve(pairs_.size() + found.size());
  wakes.reserve(pairs_.size() + found.size());
  const auto add = [&](ElementPair pair, double wake) {
    pairs.push_back(pair);
    wakes.push_back(wake);
  };
  std::size_t old = 0;
  const auto keep_until = [&](ElementPair pair) {
    for (; old < pairs_.size() && pairs_[old] < pair; ++old) {
      const bool was_searched = is_due[static_cast<std::size_t>(pairs_[old].first)] != 0 ||
                                is_due[static_cast<std::size_t>(pairs_[old].second)] != 0;
      if (!was_searched) add(pairs_[old], wakes_[old]);
    }
  };
  for (const ElementPair pair : found) {
    keep_until(pair);
    const bool is_known = old < pairs_.size() && pairs_[old] == pair;
    add(pair, is_known ? wakes_[old] : std::numeric_limits<double>::lowest());
    if (is_known) ++old;
  }
  keep_until({std::numeric_limits<std::int32_t>::max(), 0});
  if (4 * pairs.capacity() > 5 * pairs.size()) {
    pairs.shrink_to_fit();
    wakes.shrink_to_fit();
  }
  pairs_ = std::move(pairs);
  wakes_ = std::move(wakes);
}

void PairWatch::find_due(const ContactElements& pieces, double early, const Motion& motion,
                         std::vector<std::size_t>& due) const {
  due.clear();
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (!(motion_of(pieces, motion, pairs_[p]) + early < wakes_[p])) due.push_back(p);
  }
}

void PairWatch::bound_elements(const ContactElements& pieces, Motion& motion) const {
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    motion.bound(static_cast<std::size_t>(pieces.element_of(pairs_[p].first)),
                 static_cast<std::size_t>(pieces.element_of(pairs_[p].second)),
                 wakes_[p] - motion_of(pieces, motion, pairs_[p]));
  }
}

}  // namespace knitmech::contact
