#pragma once

#include <filesystem>
#include <vector>

#include "study/run_study.h"
#include "study/study.h"

namespace knitmech::study {

/// In the folder of a study: the run folders of its variants.
inline constexpr const char* kRunsFolder = "runs";

/// Makes the folder of a study, or takes over that of an earlier one; what is in it stays.
/// @throws InputError, without touching anything, if it is a file, or a folder with something in it that is no study
/// @throws FileError if it cannot be written
void prepare_folder(const std::filesystem::path& folder, const Study& study);

/// Writes table.csv, a line for each variant, and study.json, the same for programs.
/// @throws FileError if they cannot be written
void write_tables(const std::filesystem::path& folder, const Study& study, const std::vector<VariantState>& states);

}  // namespace knitmech::study
