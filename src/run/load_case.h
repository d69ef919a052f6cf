#pragma once

#include <filesystem>

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

}  // namespace knitmech::run
