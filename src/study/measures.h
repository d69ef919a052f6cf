#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace knitmech::study {

/// One number of a run; its name carries the unit. Empty where the run has none.
struct Measure {
  std::string name;
  std::optional<double> value;
};

/// What a table of runs tells of each: how far the test came, its quality, then force, work and width at the given
/// strains. Always the same names in the same order for the same strains.
///
/// Force at a strain: the mean over the 1 % of strain up to there (results::kWindow), as a snap of one loop is a peak
/// in it. Reads summary.json and history.csv of the run folder; a run that has none gives empty values. \param strains
/// [-]
[[nodiscard]] std::vector<Measure> measures_of(const std::filesystem::path& run_folder,
                                               const std::vector<double>& strains);

}  // namespace knitmech::study
