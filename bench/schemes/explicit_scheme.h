#pragma once

#include <string>

#include "model/model.h"
#include "schemes/scheme.h"

namespace knitmech::bench {

/// How the explicit solver of the program is set.
struct ExplicitScheme {
  std::string name;
  double slower = 1;  ///< by which the grip is slower than in the model, at the same masses [-]
  bool adapts_pace = false;
  bool selective_mass = false;
};

/// Explicit dynamics with the automatic mass scaling of the model. Each step evaluates the forces once.
[[nodiscard]] SchemeResult run_explicit(const model::Model& model, const ExplicitScheme& scheme);

}  // namespace knitmech::bench
