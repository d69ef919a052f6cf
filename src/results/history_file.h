#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "model/frame.h"

namespace knitmech::results {

/// In the run folder.
inline constexpr const char* kHistoryFile = "history.csv";

/// First line of history.csv; every name carries its unit.
inline constexpr const char* kHistoryHeader =
    "time_s,displacement_mm,strain,force_top_N,force_bottom_N,external_work_mJ,internal_energy_mJ,stretch_energy_mJ,"
    "kinetic_energy_mJ,"
    "contact_energy_mJ,friction_loss_mJ,damping_loss_mJ,break_loss_mJ,width_mm,contacts,contact_normal_force_N,"
    "largest_elastic_slip_mm,largest_penetration_mm,step_s";

inline constexpr std::size_t kHistoryColumns = 19;

/// The numbers of a row in the order of kHistoryHeader.
[[nodiscard]] std::array<double, kHistoryColumns> history_values(const model::HistoryRow& row);

/// One line of history.csv with its line end. Numbers are as short as they can be and still read back to the same bits.
[[nodiscard]] std::string history_line(const model::HistoryRow& row);

/// Reads a history.csv (docs/results.md). Lines may end in LF or CRLF, and empty lines at the end are allowed.
///
/// Throws FileError if the file cannot be read, and InputError with file, line and column if the header differs from
/// kHistoryHeader, a row has too many or too few numbers, or something is not a number.
[[nodiscard]] std::vector<model::HistoryRow> read_history(const std::filesystem::path& path);

}  // namespace knitmech::results
