#include "run/export_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "exchange/abaqus_writer.h"
#include "solve/mass_scaling.h"

namespace knitmech::run {
namespace {

constexpr std::array kFormats{ExportFormat{"abaqus", "Abaqus/Explicit input file", "inp"}};

std::string abaqus_text(const LoadedCase& loaded) {
  exchange::AbaqusOptions options;
  options.mass_scaling = loaded.input.solver.mass_scaling ? *loaded.input.solver.mass_scaling
                                                          : solve::automatic_mass_scaling(loaded.model);
  options.bulk_viscosity = loaded.input.solver.bulk_viscosity;
  std::ostringstream text;
  exchange::write_abaqus(text, loaded.model, options);
  return std::move(text).str();
}

}  // namespace

std::span<const ExportFormat> export_formats() {
  return kFormats;
}

std::string exported(const LoadedCase& loaded, std::string_view format) {
  if (format == "abaqus") return abaqus_text(loaded);
  std::vector<std::string_view> names;
  names.reserve(kFormats.size());
  for (const ExportFormat& each : kFormats) names.push_back(each.name);
  throw InputError(
      fmt::format("there is no format {}; the formats are {}", base::in_quotes(format), base::alternatives(names)));
}

}  // namespace knitmech::run
