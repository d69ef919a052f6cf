#pragma once

#include <filesystem>
#include <vector>

#include "study/run_study.h"
#include "study/study.h"

namespace knitmech::study {

/// In the folder of a study.
inline constexpr const char* kStudyReportFile = "report.html";

/// Writes report.html, one page that needs no other file and no network, and its charts as SVG in figures/: the table
/// of all runs, their curves in one chart, what each parameter does to work and force, the shape of the fabrics, and
/// the fabrics themselves. Runs that are not completed stand in the table with their reason.
/// @throws FileError if it cannot be written
void write_study_report(const std::filesystem::path& folder, const Study& study,
                        const std::vector<VariantState>& states);

}  // namespace knitmech::study
