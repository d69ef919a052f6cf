#include "run/export_decks.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "exchange/abaqus_writer.h"
#include "exchange/calculix_beams.h"
#include "exchange/calculix_solids.h"
#include "exchange/lsdyna_writer.h"
#include "exchange/openradioss_writer.h"
#include "solve/mass_scaling.h"

namespace knitmech::run {
namespace {

constexpr int kFewestPictures = 20;

double mass_scaling_of(const ExportSource& source) {
  const auto& given = source.input.solver.mass_scaling;
  return given ? *given : solve::automatic_mass_scaling(source.model);
}

/// Pictures at even distances, as many as the run stores frames, for decks that know no list of times.
int pictures_of(const ExportSource& source) {
  return std::max(kFewestPictures, static_cast<int>(source.input.output.frames_at.size()));
}

}  // namespace

std::vector<std::string> abaqus_files(const ExportSource& source) {
  const exchange::AbaqusOptions options{.mass_scaling = mass_scaling_of(source),
                                        .bulk_viscosity = source.input.solver.bulk_viscosity};
  std::ostringstream text;
  exchange::write_abaqus(text, source.model, options);
  return {std::move(text).str()};
}

std::vector<std::string> calculix_beams_files(const ExportSource& source) {
  std::ostringstream text;
  exchange::write_calculix_beams(text, source.model);
  return {std::move(text).str()};
}

std::vector<std::string> calculix_solids_files(const ExportSource& source) {
  std::ostringstream text;
  exchange::write_calculix_solids(text, source.model);
  return {std::move(text).str()};
}

std::vector<std::string> openradioss_files(const ExportSource& source) {
  const exchange::OpenRadiossOptions options{.run_name = source.stem,
                                             .mass_scaling = mass_scaling_of(source),
                                             .history_points = source.input.output.history_points,
                                             .pictures = pictures_of(source)};
  std::ostringstream starter, engine;
  exchange::write_openradioss_starter(starter, source.model, options);
  exchange::write_openradioss_engine(engine, source.model, options);
  return {std::move(starter).str(), std::move(engine).str()};
}

std::vector<std::string> lsdyna_files(const ExportSource& source) {
  const exchange::LsDynaOptions options{.mass_scaling = mass_scaling_of(source),
                                        .history_points = source.input.output.history_points,
                                        .pictures = pictures_of(source)};
  std::ostringstream text;
  exchange::write_lsdyna(text, source.model, options);
  return {std::move(text).str()};
}

}  // namespace knitmech::run
