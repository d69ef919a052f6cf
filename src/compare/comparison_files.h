#pragma once

#include <filesystem>

namespace knitmech::compare {

/// In the folder of a run.
inline constexpr const char* kCompareFolder = "compare";

inline constexpr const char* kCompareTable = "compare.csv";
inline constexpr const char* kCompareJson = "compare.json";
inline constexpr const char* kCompareChart = "compare.svg";

/// Removes the comparison in the folder of a run that goes on or begins anew, to which it would not belong.
void remove_comparison(const std::filesystem::path& run);

}  // namespace knitmech::compare
