#include "beam/strength_watch.h"

#include <algorithm>
#include <atomic>

#include "base/blocks.h"
#include "base/vectorise.h"

namespace knitmech::beam {

namespace {

/// Axial strain at which the force of a section reaches its strength [-].
double breaking_strain(const model::Model& model, int section, double strength) {
  const auto law = model.axial_laws.find(section);
  if (law != model.axial_laws.end()) return law->second.strain_at(strength);
  return strength / model.sections[static_cast<std::size_t>(section)].axial_stiffness;
}

KNITMECH_INLINE double utilisation(const double* x, const double* y, const double* z, const double* inverse_squared,
                                   std::size_t i) {
  const double dx = x[i + 1] - x[i];
  const double dy = y[i + 1] - y[i];
  const double dz = z[i + 1] - z[i];
  return (dx * dx + dy * dy + dz * dz) * inverse_squared[i];
}

KNITMECH_VECTORISE double largest_utilisation(const double* x, const double* y, const double* z,
                                              const double* inverse_squared, std::size_t begin, std::size_t end) {
  double largest = 0;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = begin; i < end; ++i) {
    const double here = utilisation(x, y, z, inverse_squared, i);
    largest = largest > here ? largest : here;
  }
  return largest;
}

}  // namespace

StrengthWatch::StrengthWatch(const model::Model& model, const Elements& elements)
    : is_needed_(!model.strengths.empty()) {
  if (!is_needed_) return;
  inverse_limit_squared_.assign(elements.size(), 0.0);
  for (const auto& [section, strength] : model.strengths) {
    const double limit = 1 + breaking_strain(model, section, strength);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (elements.axial[i] == 0 || model.element_section[i] != section) continue;
      const double inverse = elements.inverse_length[i] / limit;
      inverse_limit_squared_[i] = inverse * inverse;
    }
  }
}

std::vector<std::size_t> StrengthWatch::overloaded(const model::State& state, const base::ThreadTeam& team) const {
  if (!is_needed_) return {};
  const model::VectorArray& at = state.position;
  const std::size_t n = inverse_limit_squared_.size() - 1;
  const double* const limits = inverse_limit_squared_.data();
  std::atomic<bool> is_any = false;
  team.for_ranges(n, base::kBlock, [&](std::size_t begin, std::size_t end) {
    if (largest_utilisation(at.x.data(), at.y.data(), at.z.data(), limits, begin, end) >= 1) is_any = true;
  });
  if (!is_any) return {};
  const auto of = [&](std::size_t i) { return utilisation(at.x.data(), at.y.data(), at.z.data(), limits, i); };
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < n; ++i) {
    if (of(i) >= 1) found.push_back(i);
  }
  std::ranges::stable_sort(found, [&](std::size_t a, std::size_t b) { return of(a) > of(b); });
  return found;
}

}  // namespace knitmech::beam
