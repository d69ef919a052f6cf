#include "contact/motion.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "base/blocks.h"
#include "base/vectorise.h"

namespace knitmech::contact {

namespace {

/// An element moves by no more than the node that moved more. \return largest motion minus bound [mm]
KNITMECH_VECTORISE double add_moves(const double* moved, double besides, const double* bound,
                                    double* __restrict of_element, std::size_t begin, std::size_t end) {
  double beyond = std::numeric_limits<double>::lowest();
#pragma omp simd reduction(max : beyond)
  for (std::size_t i = begin; i < end; ++i) {
    const double all = of_element[i] + (moved[i] > moved[i + 1] ? moved[i] : moved[i + 1]) + besides;
    of_element[i] = all;
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

void Motion::add(const std::vector<double>& moved, double besides, const base::ThreadTeam& team) {
  std::atomic<bool> has_reached = false;
  team.for_ranges(of_element_.size() - 1, base::kBlock, [&](std::size_t begin, std::size_t end) {
    if (add_moves(moved.data(), besides, bound_.data(), of_element_.data(), begin, end) >= 0) has_reached = true;
  });
  has_reached_a_bound_ = has_reached;
}

double Motion::largest_since_search() const {
  return largest_difference(of_element_, searched_);
}

double Motion::largest_since_check() const {
  return largest_difference(of_element_, checked_);
}

void Motion::set_bounds(double since_search, double since_check) {
  for (std::size_t i = 0; i < bound_.size(); ++i) {
    bound_[i] = std::min(searched_[i] + since_search, checked_[i] + since_check);
  }
}

}  // namespace knitmech::contact
