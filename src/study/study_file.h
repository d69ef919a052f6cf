#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "study/study.h"

namespace knitmech::study {

/// A study file [TOML] and the base case that it names (docs/studies.md). Paths in it are relative to its folder.
///
/// @throws model::CaseFileError for the first mistake in it, or in the base case
/// @throws FileError if one of them cannot be read
[[nodiscard]] Study read_study_file(const std::filesystem::path& path);

/// The same from the text of a study file.
[[nodiscard]] Study parse_study(std::string_view text, const std::filesystem::path& path);

}  // namespace knitmech::study
