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
  pairs.shrink_to_fit();
  wakes.shrink_to_fit();
  pairs_ = std::move(pairs);
  wakes_ = std::move(wakes);
}

}  // namespace knitmech::contact
