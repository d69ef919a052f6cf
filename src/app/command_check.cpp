#include <fmt/format.h>

#include "app/commands.h"
#include "app/run_texts.h"
#include "model/facts.h"
#include "run/check_json.h"
#include "run/load_case.h"
#include "solve/mass_scaling.h"

namespace knitmech::app {

ExitCode run_command(const CheckOptions& options) {
  const run::LoadedCase loaded = run::load_case(options.case_file);
  const model::FabricFacts facts = model::describe(loaded.input, loaded.model);
  const double mass_scaling = loaded.input.solver.mass_scaling ? *loaded.input.solver.mass_scaling
                                                               : solve::automatic_mass_scaling(loaded.model);
  fmt::print("{}", options.json ? run::check_json(loaded, facts, mass_scaling) + "\n"
                                : check_text(loaded, facts, mass_scaling));
  return kDone;
}

}  // namespace knitmech::app
