#include "contact/pair_watch.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/blocks.h"

namespace knitmech::contact {

void PairWatch::renew(const std::vector<char>& is_due, const std::vector<ElementPair>& found) {
  PairWatch next;
  next.reserve(pairs_.size() + found.size(), looks_.size());
  std::size_t old = 0;
  const auto keep_until = [&](ElementPair pair) {
    for (; old < pairs_.size() && pairs_[old] < pair; ++old) {
      const bool was_searched = is_due[static_cast<std::size_t>(pairs_[old].first)] != 0 ||
                                is_due[static_cast<std::size_t>(pairs_[old].second)] != 0;
      if (!was_searched) next.add(*this, old);
    }
  };
  for (const ElementPair pair : found) {
    keep_until(pair);
    if (old < pairs_.size() && pairs_[old] == pair) {
      next.add(*this, old++);
    } else {
      next.add(pair);
    }
  }
  keep_until({std::numeric_limits<std::int32_t>::max(), 0});
  if (4 * next.pairs_.capacity() > 5 * next.pairs_.size()) next.shrink_to_fit();
  *this = std::move(next);
}

void PairWatch::reserve(std::size_t n_pairs, std::size_t n_looks) {
  pairs_.reserve(n_pairs);
  wakes_.reserve(n_pairs);
  look_at_.reserve(n_pairs);
  looks_.reserve(n_looks);
}

void PairWatch::shrink_to_fit() {
  pairs_.shrink_to_fit();
  wakes_.shrink_to_fit();
  look_at_.shrink_to_fit();
}

/// Adds a pair that is awake.
void PairWatch::add(ElementPair pair) {
  pairs_.push_back(pair);
  wakes_.push_back(std::numeric_limits<double>::lowest());
  look_at_.push_back(kNone);
}

/// Adds a pair of another watch with what is known of it.
void PairWatch::add(const PairWatch& other, std::size_t pair) {
  add(other.pairs_[pair]);
  wakes_.back() = other.wakes_[pair];
  if (const Look* look = other.last_look(pair)) note(pairs_.size() - 1, *look);
}

void PairWatch::sort_by_elements(const ContactElements& pieces, std::size_t n_elements) {
  const auto for_elements_of = [&](ElementPair pair, const auto& call) {
    const auto a = static_cast<std::size_t>(pieces.element_of(pair.first));
    const auto b = static_cast<std::size_t>(pieces.element_of(pair.second));
    call(a);
    if (b != a) call(b);
  };
  first_on_.assign(n_elements + 1, 0);
  for (const ElementPair pair : pairs_) for_elements_of(pair, [&](std::size_t e) { ++first_on_[e + 1]; });
  std::partial_sum(first_on_.begin(), first_on_.end(), first_on_.begin());
  on_element_.resize(first_on_.back());
  // Each pair takes the first free entry, which moves on; in the end the beginnings are one element too far.
  for (std::uint32_t p = 0; p < pairs_.size(); ++p) {
    for_elements_of(pairs_[p], [&](std::size_t e) { on_element_[first_on_[e]++] = p; });
  }
  std::copy_backward(first_on_.begin(), first_on_.end() - 1, first_on_.end());
  first_on_.front() = 0;
}

void PairWatch::find_due(const ContactElements& pieces, double early, const Motion& motion,
                         const base::ThreadTeam& team, std::vector<std::size_t>& due) {
  if (first_on_.empty()) sort_by_elements(pieces, motion.n_elements());
  const auto is_due = [&](std::size_t pair) { return !(left_to(pieces, motion, pair) > early); };
  due.clear();
  at_bound_.clear();
  if (!sees_to_all_) {
    for (std::size_t e = 0; e < motion.n_elements(); ++e) {
      if (motion.is_within(0.5 * early, e)) at_bound_.push_back(e);
    }
    for (const std::size_t element : at_bound_) {
      for_pairs_on(element, [&](std::size_t pair) {
        if (is_due(pair)) due.push_back(pair);
      });
    }
    std::sort(due.begin(), due.end());
    due.erase(std::unique(due.begin(), due.end()), due.end());
    return;
  }
  found_.resize(team.size());
  team.run([&](std::size_t part) {
    const auto range = team.range_of(part, pairs_.size(), base::kBlock);
    found_[part].clear();
    for (std::size_t p = range.begin; p < range.end; ++p) {
      if (is_due(p)) found_[part].push_back(p);
    }
  });
  for (const std::vector<std::size_t>& found : found_) due.insert(due.end(), found.begin(), found.end());
}

void PairWatch::bound_elements(const ContactElements& pieces, const std::vector<std::size_t>& due,
                               const base::ThreadTeam& team, Motion& motion) {
  if (sees_to_all_) {
    sees_to_all_ = false;
    bound_all(pieces, team, motion);
    return;
  }
  for (const std::size_t pair : due) {
    at_bound_.push_back(static_cast<std::size_t>(pieces.element_of(pairs_[pair].first)));
    at_bound_.push_back(static_cast<std::size_t>(pieces.element_of(pairs_[pair].second)));
  }
  std::sort(at_bound_.begin(), at_bound_.end());
  at_bound_.erase(std::unique(at_bound_.begin(), at_bound_.end()), at_bound_.end());
  for (const std::size_t element : at_bound_) motion.unbind(element);
  for (const std::size_t element : at_bound_) {
    for_pairs_on(element, [&](std::size_t pair) {
      motion.bound(static_cast<std::size_t>(pieces.element_of(pairs_[pair].first)),
                   static_cast<std::size_t>(pieces.element_of(pairs_[pair].second)), left_to(pieces, motion, pair));
    });
  }
}

/// Every element for itself, so that threads have nothing in common.
void PairWatch::bound_all(const ContactElements& pieces, const base::ThreadTeam& team, Motion& motion) const {
  team.for_ranges(motion.n_elements(), base::kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      motion.unbind(e);
      for_pairs_on(e, [&](std::size_t pair) { motion.bound(e, e, left_to(pieces, motion, pair)); });
    }
  });
}

}  // namespace knitmech::contact
