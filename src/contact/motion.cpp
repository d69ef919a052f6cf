#include "contact/motion.h"

#include <algorithm>

#include "base/vectorise.h"

namespace knitmech::contact {

namespace {

struct Largest {
  double ever, now;
};

/// An element moves by no more than the node that moved more.
KNITMECH_VECTORISE Largest add_moves(const double* moved, double besides, double* __restrict of_element,
                                     std::size_t n) {
  double ever = 0;
  double now = 0;
#pragma omp simd reduction(max : ever, now)
  for (std::size_t i = 0; i < n; ++i) {
    const double here = (moved[i] > moved[i + 1] ? moved[i] : moved[i + 1]) + besides;
    of_element[i] += here;
    now = now > here ? now : here;
    ever = ever > of_element[i] ? ever : of_element[i];
  }
  return {ever, now};
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

void Motion::add(const std::vector<double>& moved, double besides) {
  const Largest largest = add_moves(moved.data(), besides, of_element_.data(), of_element_.size() - 1);
  largest_ = largest.ever;
  since_look_ += largest.now;
}

void Motion::start_anew() {
  std::fill(of_element_.begin(), of_element_.end(), 0.0);
  largest_ = since_look_ = 0;
}

}  // namespace knitmech::contact
