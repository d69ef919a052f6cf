#pragma once

#include "model/model.h"

namespace knitmech::solve {

/// Threads that serve a run: as many as there are processors, but no more than one per kElementsPerThread elements,
/// and at least one.
/// \param n_processors 0: not known
[[nodiscard]] int automatic_threads(int n_elements, unsigned n_processors);

/// The same for a model on this computer, with the processors that this program may use.
[[nodiscard]] int automatic_threads(const model::Model& model);

}  // namespace knitmech::solve
