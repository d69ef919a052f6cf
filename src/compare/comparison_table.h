#pragma once

#include <string>

#include "compare/comparison.h"

namespace knitmech::compare {

/// First line of compare.csv.
inline constexpr const char* kComparisonHeader =
    "strain,simulated_N_per_mm,mean_N_per_mm,lowest_N_per_mm,highest_N_per_mm";

/// The curves on their common strains as CSV, one line each with its line end. Numbers read back to the same bits.
[[nodiscard]] std::string comparison_table(const Comparison& comparison);

}  // namespace knitmech::compare
