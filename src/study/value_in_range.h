#pragma once

#include "study/study.h"

namespace knitmech::study {

/// The value at a share (0 to 1) of a variation's range; of a whole number, the nearest one.
[[nodiscard]] model::Value value_in_range(const Variation& variation, double share);

}  // namespace knitmech::study
