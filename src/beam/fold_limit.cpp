#include "beam/fold_limit.h"

#include <algorithm>
#include <cmath>

#include "base/blocks.h"

namespace knitmech::beam {

namespace {

/// cos(theta / 2) from which on an element is not folded for certain [-]; at kFold it is 0.259.
constexpr double kSurelyOpen = 0.3;

/// Vector part of q_b q_a^-1, u sin(theta / 2) in space, and cos(theta / 2).
struct Relative {
  Vector3 vector;
  double cosine;
};

Relative relative_rotation(const model::RotationArray& q, std::size_t a) {
  const std::size_t b = a + 1;
  const Vector3 va{q.x[a], q.y[a], q.z[a]};
  const Vector3 vb{q.x[b], q.y[b], q.z[b]};
  return {q.w[a] * vb - q.w[b] * va + cross(va, vb), q.w[a] * q.w[b] + dot(va, vb)};
}

}  // namespace

FoldLimit::FoldLimit(const Elements& elements) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements.fold[i] > 0) soft_.push_back({i, elements.fold[i]});
  }
  energy_of_block_.resize(base::n_blocks(soft_.size()));
  energy_of_last_.resize(energy_of_block_.size());
}

/// Returns the energy.
double FoldLimit::add_moment(const SoftElement& element, const model::State& state, model::NodalLoads& loads) {
  const Relative relative = relative_rotation(state.rotation, element.node);
  if (relative.cosine > kSurelyOpen) return 0;
  const double sine = length(relative.vector);
  const double beyond = 2 * std::atan2(sine, relative.cosine) - kFold;
  if (beyond <= 0 || sine == 0) return 0;
  const Vector3 moment = (element.stiffness * beyond / sine) * relative.vector;
  loads.moment.add(element.node, moment);
  loads.moment.add(element.node + 1, -1.0 * moment);
  return 0.5 * element.stiffness * beyond * beyond;
}

/// The last element of a block shares its second node with the next block, which may be another thread's: it comes when
/// the rest of the next block is done, so that the order of summation is always the same.
void FoldLimit::add_moments(const model::State& state, model::NodalLoads& loads, const base::ThreadTeam& team) {
  energy_ = 0;
  if (soft_.empty()) return;
  const std::size_t n = soft_.size();
  const auto add_last = [&](std::size_t block) {
    energy_of_last_[block] = add_moment(soft_[std::min((block + 1) * base::kBlock, n) - 1], state, loads);
  };
  team.for_ranges(n, base::kBlock, [&](std::size_t first, std::size_t last) {
    for (std::size_t begin = first; begin < last; begin += base::kBlock) {
      const std::size_t block = begin / base::kBlock;
      const std::size_t end = std::min(begin + base::kBlock, n);
      energy_of_block_[block] = 0;
      for (std::size_t k = begin; k + 1 < end; ++k) energy_of_block_[block] += add_moment(soft_[k], state, loads);
      if (begin > first) add_last(block - 1);
    }
  });
  for (std::size_t part = 0; part < team.size(); ++part) {
    const auto [begin, end] = team.range_of(part, n, base::kBlock);
    if (begin < end) add_last((end - 1) / base::kBlock);
  }
  for (std::size_t block = 0; block < base::n_blocks(n); ++block) {
    energy_ += energy_of_block_[block] + energy_of_last_[block];
  }
}

void FoldLimit::remove(std::size_t element) {
  std::erase_if(soft_, [&](const SoftElement& here) { return here.node == element; });
}

}  // namespace knitmech::beam
