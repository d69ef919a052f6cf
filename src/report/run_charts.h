#pragma once

#include <string>
#include <vector>

#include "model/frame.h"
#include "picture/chart.h"
#include "results/read_run.h"

namespace knitmech::report {

/// A history, and what it is called in a chart with several.
struct NamedHistory {
  std::string name;
  std::vector<model::HistoryRow> history;
};

/// Grip force over strain [%], of one run or of several; in mN where no force reaches 0.1 N.
/// \param logarithmic the force axis, which shows the toe: means over 1 % of strain, gaps below 1e-4 of the largest of
/// the same run
[[nodiscard]] picture::Chart force_chart(const std::vector<NamedHistory>& runs, bool logarithmic);

/// Work of the grip over strain [%].
[[nodiscard]] picture::Chart work_chart(const std::vector<NamedHistory>& runs);

/// Contraction of the width at mid-height, as a share of the first width [%], over strain [%].
[[nodiscard]] picture::Chart contraction_chart(const std::vector<NamedHistory>& runs);

/// Where the work went: internal energy, friction loss and the others that are not negligible, over strain [%].
[[nodiscard]] picture::Chart energy_chart(const std::vector<model::HistoryRow>& history);

/// Number of contacts, over strain [%].
[[nodiscard]] picture::Chart contact_chart(const std::vector<NamedHistory>& runs);

/// Extent across the pull [mm] of each course over its mean height [mm], at each of some frames: the waist of the
/// fabric.
[[nodiscard]] picture::Chart width_profile_chart(const model::Model& model, const std::vector<model::Frame>& frames);

}  // namespace knitmech::report
