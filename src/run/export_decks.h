#pragma once

#include <string>
#include <vector>

#include "run/export_case.h"

namespace knitmech::run {

/// Each writes the files of one format, in the order of its endings in export_formats().
[[nodiscard]] std::vector<std::string> abaqus_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> calculix_beams_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> calculix_solids_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> openradioss_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> lsdyna_files(const ExportSource& source);

}  // namespace knitmech::run
