#pragma once

#include <string>

#include "model/model.h"
#include "model/run_outcome.h"

namespace knitmech::results {

/// "Breaks: yarns broke at 3 places, first in course 2, wale 1, 12.3 mm along the yarn, at 25.3 % strain, with 6 N and
/// stretched by 21 %."; empty if none did.
[[nodiscard]] std::string breaks_text(const model::Model& model, const model::RunOutcome& outcome);

}  // namespace knitmech::results
