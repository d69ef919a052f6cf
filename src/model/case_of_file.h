#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/case.h"
#include "model/parameters.h"

namespace knitmech::model {

/// What is wrong with a parameter's being given at all: it belongs to the other way to give a fabric. Empty if nothing
/// is. @param names_file whether the case gives fabric.yarns
[[nodiscard]] std::string complaint_about_fabric(const Parameter& parameter, bool names_file);

/// Reads the file of yarns that a case names, if it names one, and puts it into the case: yarn_file, its checksum, and
/// as its name the one that a copy beside the case has.
///
/// @param folder of the case file; none: the text of the case stands nowhere
/// @throws FileError if the file cannot be read
/// @throws InputError with one sentence: no folder, a damaged file, another checksum than the case gives, no unit or
/// two,
///         a closed yarn
void read_yarn_file_of(Case& input, const std::optional<std::filesystem::path>& folder);

}  // namespace knitmech::model
