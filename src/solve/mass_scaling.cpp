#include "solve/mass_scaling.h"

#include <algorithm>
#include <cmath>

#include "solve/constants.h"

namespace knitmech::solve {

double automatic_mass_scaling(const model::Model& model) {
  const yarn::Section& section = model.sections.front();
  const double bending_speed =
      std::sqrt(section.bending_stiffness / section.mass_per_length) / model.half_stitch_length;
  return std::max(1.0, std::pow(kQuasiStaticSpeed * bending_speed / model.test.speed, 2));
}

double selective_length(const model::Model& model) {
  if (!model.ties.empty() || !model.strengths.empty()) return 0;
  return kSelectiveShare * model.half_stitch_length;
}

bool adapts_pace(const model::Case& input, double mass_scaling) {
  return !input.solver.mass_scaling && mass_scaling > 1;
}

}  // namespace knitmech::solve
