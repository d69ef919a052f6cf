#pragma once

#include <stdexcept>
#include <string>

#include "model/build_model.h"
#include "model/case_file.h"
#include "solve/explicit_solver.h"
#include "solve/mass_scaling.h"
#include "solve/simulate.h"

namespace knitmech::bench {

/// The main example, examples/02-wale-tension, at another size, mesh and centreline.
struct Example {
  int wales = 9, courses = 15;
  int elements_per_erc = 10;
  model::Centreline centreline = model::Centreline::smooth;
};

[[nodiscard]] inline model::Case case_of(const Example& example) {
  model::Case input = model::read_case_file(std::string(KNITMECH_SOURCE_DIR) + "/examples/02-wale-tension/case.toml");
  input.fabric.wales = example.wales;
  input.fabric.courses = example.courses;
  input.fabric.elements_per_erc = example.elements_per_erc;
  input.contact.centreline = example.centreline;
  return input;
}

/// What `knitmech run` sets for a case whose masses and pace the program chooses.
[[nodiscard]] inline solve::ExplicitSettings settings_of(const model::Case& input, const model::Model& model,
                                                         int threads) {
  const solve::SimulationSettings chosen = solve::settings_from(input);
  if (chosen.mass_scaling) throw std::logic_error("The main example leaves its masses to the program.");
  const double mass_scaling = solve::automatic_mass_scaling(model);
  return {.mass_scaling = mass_scaling,
          .bulk_viscosity = chosen.bulk_viscosity,
          .mass_damping = chosen.mass_damping,
          .step_factor = chosen.step_factor,
          .adapts_pace = chosen.adapts_pace && mass_scaling > 1,
          .threads = threads,
          .finest_length = chosen.selective_mass && mass_scaling > 1 ? solve::selective_length(model) : 0};
}

}  // namespace knitmech::bench
