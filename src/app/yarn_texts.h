#pragma once

#include <string>

#include "app/yarn_analysis.h"

namespace knitmech::app {

/// What `yarn` prints of its result.
[[nodiscard]] std::string yarn_text(const YarnAnalysis& analysis);

/// The section [yarn] for a case file: of E, or of the measured curve if there is a law. Empty without diameter or
/// density, which a case needs.
[[nodiscard]] std::string yarn_section_block(const YarnAnalysis& analysis);

/// The mean curve with its range as CSV.
[[nodiscard]] std::string mean_curve_csv(const yarn::MeanCurve& mean);

}  // namespace knitmech::app
