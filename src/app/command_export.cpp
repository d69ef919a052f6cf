#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <system_error>

#include "app/commands.h"
#include "base/errors.h"
#include "base/text.h"
#include "exchange/abaqus_writer.h"
#include "results/atomic_file.h"
#include "run/load_case.h"
#include "solve/mass_scaling.h"

namespace knitmech::app {
namespace {

std::string abaqus_text(const run::LoadedCase& loaded) {
  exchange::AbaqusOptions options;
  options.mass_scaling = loaded.input.solver.mass_scaling ? *loaded.input.solver.mass_scaling
                                                          : solve::automatic_mass_scaling(loaded.model);
  options.bulk_viscosity = loaded.input.solver.bulk_viscosity;
  std::ostringstream text;
  exchange::write_abaqus(text, loaded.model, options);
  return std::move(text).str();
}

}  // namespace

ExitCode run_command(const ExportOptions& options) {
  const run::LoadedCase loaded = run::load_case(options.case_file);
  const std::string text = abaqus_text(loaded);
  if (options.file.empty()) {
    std::cout << text << std::flush;
    return kDone;
  }
  std::error_code not_there;
  if (std::filesystem::equivalent(options.file, options.case_file, not_there)) {
    throw InputError(fmt::format("{} is the case file itself; give another name", base::in_quotes(options.file)));
  }
  results::write_file_atomically(options.file, text);
  fmt::print("Wrote {}: {} nodes, {} elements\n", options.file, loaded.model.n_nodes(), loaded.model.n_elements());
  return kDone;
}

}  // namespace knitmech::app
