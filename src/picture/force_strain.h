#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/frame.h"
#include "picture/chart.h"

namespace knitmech::picture {

/// Grip force over strain [%]: the driven (top) and the held (bottom) grip, or one line if the two lie within a line's
/// width of each other everywhere. In N, or in mN if no force reaches 0.1 N.
[[nodiscard]] Chart force_strain_chart(const std::vector<model::HistoryRow>& history, const std::string& title);

/// Writes that chart as SVG. Throws FileError with the path and the reason.
void write_force_strain_chart(const std::filesystem::path& path, const std::vector<model::HistoryRow>& history,
                              const std::string& title);

}  // namespace knitmech::picture
