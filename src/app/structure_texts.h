#pragma once

#include <string>

#include "model/facts.h"
#include "model/run_outcome.h"
#include "run/load_case.h"

namespace knitmech::app {

/// How the side edges are made: "tied: 112 crossings of the edge stitches are tied".
[[nodiscard]] std::string structure_text(const model::Case& input, const model::FabricFacts& facts);

/// "EA 19.2265 N, EI 0.0173039 N mm^2, GJ 0.0124488 N mm^2".
[[nodiscard]] std::string stiffness_text(const yarn::Section& section);

/// "34 filaments of 0.016 mm, 0.4 turns per mm"; empty unless the yarn is given by its filaments.
[[nodiscard]] std::string filaments_text(const model::YarnStiffness& yarn);

/// Friction of the edge yarn on any yarn [-].
[[nodiscard]] double edge_friction(const model::Case& input);

/// "Ties: gave way by at most 0.00012 mm, 0.1 % of the yarn diameter."; empty if the model has no ties.
[[nodiscard]] std::string ties_text(const model::Model& model, const model::RunOutcome& outcome);

}  // namespace knitmech::app
