#pragma once

#include <filesystem>
#include <vector>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::results {

/// Reads a table of contacts (contact_file.h) of a model. All numbers come back with the same bits, but the angle,
/// which the table gives in degrees: it is right to the last digit but one.
///
/// Throws FileError if the file cannot be read, and InputError with file, line and column if the header differs from
/// kContactHeader, a cell does not hold what it should, or a yarn is none of the model.
[[nodiscard]] std::vector<model::ContactRecord> read_contacts(const std::filesystem::path& path,
                                                              const model::Model& model);

}  // namespace knitmech::results
