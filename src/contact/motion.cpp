#include "contact/motion.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "base/blocks.h"
#include "base/vectorise.h"

namespace knitmech::contact {

namespace {

/// An element moves by no more than the node that moved more. \return largest motion minus bound [mm]
KNITMECH_VECTORISE double add_moves(const double* moved, const double* turned, double besides, const double* bound,
                                    double* __restrict of_element, double* __restrict turned_in_all, std::size_t begin,
                                    std::size_t end) {
  double beyond = std::numeric_limits<double>::lowest();
#pragma omp simd reduction(max : beyond)
  for (std::size_t i = begin; i < end; ++i) {
    const double all = of_element[i] + (moved[i] > moved[i + 1] ? moved[i] : moved[i + 1]) + besides;
    of_element[i] = all;
    turned_in_all[i] += turned[i] > turned[i + 1] ? turned[i] : turned[i + 1];
    beyond = beyond > all - bound[i] ? beyond : all - bound[i];
  }
  return beyond;
}

/// Over all elements; the last node starts none.
double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) largest = std::max(largest, a[i] - b[i]);
  return largest;
}

}  // namespace

CommonMotion fit_common_motion(const model::State& state) {
  const std::vector<double>& y = state.position.y;
  const std::vector<double>& v = state.velocity.y;
  const auto n = static_cast<double>(y.size());
  double sum_y = 0;
  double sum_v = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    sum_y += y[i];
    sum_v += v[i];
  }
  double yy = 0;
  double yv = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double from_middle = y[i] - sum_y / n;
    yy += from_middle * from_middle;
    yv += from_middle * v[i];
  }
  const double rate = yy > 0 ? yv / yy : 0;
  return {sum_v / n - rate * sum_y / n, rate};
}

void Motion::add(const std::vector<double>& moved, const std::vector<double>& turned, double besides,
                 const base::ThreadTeam& team) {
  std::atomic<bool> has_reached = false;
  team.for_ranges(of_element_.size() - 1, base::kBlock, [&](std::size_t begin, std::size_t end) {
    const double beyond =
        add_moves(moved.data(), turned.data(), besides, bound_.data(), of_element_.data(), turned_.data(), begin, end);
    if (beyond >= 0) has_reached = true;
  });
  has_reached_a_bound_ = has_reached;
}

double Motion::largest_since_search() const {
  return largest_difference(of_element_, searched_);
}

double Motion::largest_since_check() const {
  return largest_difference(of_element_, checked_);
}

}  // namespace knitmech::contact
