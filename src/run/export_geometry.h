#pragma once

#include <string>
#include <vector>

#include "run/export_case.h"

namespace knitmech::run {

/// Each writes the yarns of a source in one format, in the shape of its frame or else as at the start. Elements that
/// have broken leave a gap. Each throws InputError if there is no element left, or the file becomes too large.
[[nodiscard]] std::vector<std::string> vtp_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> gltf_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> obj_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> stl_files(const ExportSource& source);

/// The same as centrelines (curves/write_lines.h), a yarn as many of them as it has pieces. The formats draw a smooth
/// curve through evenly spaced points, so every element is cut into as many pieces as the most bent one needs. A yarn
/// whose diameter changes along it has the radius of its beginning.
[[nodiscard]] std::vector<std::string> step_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> csv_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> bcc_files(const ExportSource& source);
[[nodiscard]] std::vector<std::string> yarns_files(const ExportSource& source);

}  // namespace knitmech::run
