#include "run/export_decks.h"

#include <sstream>
#include <utility>

#include "exchange/abaqus_writer.h"
#include "solve/mass_scaling.h"

namespace knitmech::run {
namespace {

double mass_scaling_of(const ExportSource& source) {
  const auto& given = source.input.solver.mass_scaling;
  return given ? *given : solve::automatic_mass_scaling(source.model);
}

}  // namespace

std::vector<std::string> abaqus_files(const ExportSource& source) {
  const exchange::AbaqusOptions options{.mass_scaling = mass_scaling_of(source),
                                        .bulk_viscosity = source.input.solver.bulk_viscosity};
  std::ostringstream text;
  exchange::write_abaqus(text, source.model, options);
  return {std::move(text).str()};
}

}  // namespace knitmech::run
