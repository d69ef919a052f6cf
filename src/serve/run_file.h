#pragma once

#include <filesystem>
#include <string>

namespace knitmech::serve {

/// A file of a run folder.
struct RunFile {
  std::string content, type;
};

/// Largest file that is sent [bytes]; frames of large fabrics are larger, those are for other programs.
inline constexpr std::uintmax_t kLargestFile = 256U << 20U;

/// Reads a file of a run folder. \param path from the folder on
/// @throws Refusal with 404 for what is no file in the folder, also by "..", a link or a name with a dot in front
[[nodiscard]] RunFile read_run_file(const std::filesystem::path& folder, const std::string& path);

}  // namespace knitmech::serve
