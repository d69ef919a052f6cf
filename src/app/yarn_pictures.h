#pragma once

#include "app/yarn_analysis.h"
#include "picture/chart.h"

namespace knitmech::app {

/// The mean curve, the line of the fit over its range (or the measured law, if there is one), and all specimens as one
/// series with gaps. Force in N, or in mN if no force reaches 0.1 N.
[[nodiscard]] picture::Chart yarn_chart(const YarnAnalysis& analysis);

}  // namespace knitmech::app
