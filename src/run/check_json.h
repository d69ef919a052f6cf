#pragma once

#include <string>

#include "model/facts.h"
#include "run/load_case.h"

namespace knitmech::run {

/// What is known of a case before it is run, as a JSON object; the units are in the keys. `knitmech check --json`
/// prints it, and the Python module gives it as a dictionary. \param mass_scaling in use [-], see resolved_settings()
[[nodiscard]] std::string check_json(const LoadedCase& loaded, const model::FabricFacts& facts, double mass_scaling);

}  // namespace knitmech::run
