#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "model/case.h"
#include "model/model.h"

namespace knitmech::run {

/// A case and the model built from it.
struct LoadedCase {
  model::Case input;
  model::Model model;
};

/// Reads a case file and builds its model.
///
/// @throws model::CaseFileError for wrong input; a geometry that cannot be is reported with file, line and key as well
/// @throws FileError if the file cannot be read
[[nodiscard]] LoadedCase load_case(const std::filesystem::path& path);

/// The same from the text of a case file. \param name of the file, for messages \param folder where a file of yarns is
/// looked for; none: a case that names one is refused
[[nodiscard]] LoadedCase load_case_text(std::string_view text, const std::string& name,
                                        const std::optional<std::filesystem::path>& folder = std::nullopt);

}  // namespace knitmech::run
