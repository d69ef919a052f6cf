#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/frame.h"

namespace knitmech::compare {

/// The force-strain curve of a run, and what a comparison needs to know of the run.
struct SimulatedCurve {
  std::string title;
  std::string status;           ///< of the run: "completed", "running", ...
  double gauge_length = 0;      ///< [mm]
  double width = 0;             ///< of the fabric at the start [mm]
  std::vector<double> strains;  ///< ascending [-]
  std::vector<double> forces;   ///< as many [N], mean of both grips
};

/// Strains and forces of a history up to the row before the first break of a yarn; rows whose strain does not exceed
/// the one before are left out.
void set_curve(SimulatedCurve& curve, const std::vector<model::HistoryRow>& history);

/// The curve in a run folder.
///
/// Throws FileError if the folder or its history.csv cannot be read, and InputError if it is none of a KnitMech run or
/// its history has less than two rows.
[[nodiscard]] SimulatedCurve read_simulated_curve(const std::filesystem::path& run);

}  // namespace knitmech::compare
