#include "solve/yarn_breaks.h"

#include <algorithm>
#include <cmath>

#include "model/places.h"

namespace knitmech::solve {

YarnBreaks::YarnBreaks(const model::Model& model, const beam::Elements& elements, double mass_scaling)
    : model_(model), mass_scaling_(mass_scaling), watch_(model, elements) {}

std::vector<std::size_t> YarnBreaks::find(const model::State& state, const base::ThreadTeam& team) {
  std::vector<std::size_t> broken;
  for (const std::size_t element : watch_.overloaded(state, team)) {
    if (is_being_unloaded(element, state.time)) continue;
    breaks_.push_back({element, model::yarn_of_node(model_, element), state.time});
    watch_.remove(element);
    broken.push_back(element);
  }
  return broken;
}

double YarnBreaks::wave_speed(std::size_t element) const {
  const int section = model_.element_section[element];
  const yarn::Section& of = model_.section_of(element);
  const auto law = model_.axial_laws.find(section);
  const double force = model_.strengths.at(section);
  const double stiffness = law == model_.axial_laws.end() ? of.axial_stiffness : force / law->second.strain_at(force);
  return std::sqrt(stiffness / (of.mass_per_length * mass_scaling_));
}

bool YarnBreaks::is_being_unloaded(std::size_t element, double time) const {
  const int yarn = model::yarn_of_node(model_, element);
  return std::ranges::any_of(breaks_, [&](const Break& other) {
    const double distance = std::abs(model_.arc_length[element] - model_.arc_length[other.element]);
    return other.yarn == yarn && (time - other.time) * wave_speed(element) < 2 * distance;
  });
}

}  // namespace knitmech::solve
