#include "beam/nonlinear_axial.h"

#include <map>

#include "base/blocks.h"

namespace knitmech::beam {

namespace {

/// Strain below which force over strain would be the quotient of two rounding errors [-]; the law is its slope there.
constexpr double kNoStrain = 1e-12;

double axial_strain(const Elements& elements, const model::State& state, std::size_t i) {
  return length(state.position.at(i + 1) - state.position.at(i)) * elements.inverse_length[i] - 1;
}

/// Integral of N less N epsilon / 2, of an element [mJ].
double beyond_secant(const yarn::AxialLaw& law, double strain, double inverse_length) {
  if (strain <= kNoStrain) return 0;
  const yarn::AxialResponse response = law.at(strain);
  return (response.energy - 0.5 * response.force * strain) / inverse_length;
}

}  // namespace

NonlinearAxial::NonlinearAxial(const model::Model& model) {
  std::map<int, std::size_t> index_of_section;
  for (const auto& [section, law] : model.axial_laws) {
    index_of_section[section] = laws_.size();
    laws_.push_back(law);
  }
  for (const model::ModelYarn& yarn : model.yarns) {
    for (int i = yarn.first_node; i + 1 < yarn.first_node + yarn.n_nodes; ++i) {
      const auto element = static_cast<std::size_t>(i);
      const auto law = index_of_section.find(model.element_section[element]);
      if (law != index_of_section.end()) with_law_.push_back({element, law->second});
    }
  }
}

void NonlinearAxial::set_secants(const model::State& state, Elements& elements, const base::ThreadTeam& team) const {
  if (with_law_.empty()) return;
  team.for_ranges(with_law_.size(), base::kBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const LawElement& here = with_law_[k];
      const yarn::AxialLaw& law = laws_[here.law];
      const double strain = axial_strain(elements, state, here.element);
      elements.axial[here.element] = strain > kNoStrain ? law.force(strain) / strain : law.slope_at_zero();
    }
  });
}

double NonlinearAxial::energy_beyond_secants(const Elements& elements, const model::State& state,
                                             const base::ThreadTeam& team) const {
  return base::sum_over_blocks(team, with_law_.size(), [&](std::size_t begin, std::size_t end) {
    double energy = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = with_law_[k].element;
      energy += beyond_secant(laws_[with_law_[k].law], axial_strain(elements, state, i), elements.inverse_length[i]);
    }
    return energy;
  });
}

void NonlinearAxial::correct_stretch_energy(const Elements& elements, model::Frame& frame) const {
  for (const LawElement& here : with_law_) {
    frame.stretch_energy[here.element] +=
        beyond_secant(laws_[here.law], frame.axial_strain[here.element], elements.inverse_length[here.element]);
  }
}

void NonlinearAxial::remove(std::size_t element) {
  std::erase_if(with_law_, [&](const LawElement& here) { return here.element == element; });
}

}  // namespace knitmech::beam
