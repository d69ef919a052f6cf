#include "beam/fold_limit.h"

#include <cmath>

namespace knitmech::beam {

namespace {

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
}

void FoldLimit::add_moments(const model::State& state, model::NodalLoads& loads) {
  energy_ = 0;
  for (const SoftElement& element : soft_) {
    const Relative relative = relative_rotation(state.rotation, element.node);
    const double sine = length(relative.vector);
    const double beyond = 2 * std::atan2(sine, relative.cosine) - kFold;
    if (beyond <= 0 || sine == 0) continue;
    const Vector3 moment = (element.stiffness * beyond / sine) * relative.vector;
    loads.moment.add(element.node, moment);
    loads.moment.add(element.node + 1, -1.0 * moment);
    energy_ += 0.5 * element.stiffness * beyond * beyond;
  }
}

void FoldLimit::remove(std::size_t element) {
  std::erase_if(soft_, [&](const SoftElement& here) { return here.node == element; });
}

}  // namespace knitmech::beam
