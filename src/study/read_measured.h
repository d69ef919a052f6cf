#pragma once

#include <optional>

#include "study/study.h"
#include "study/study_entries.h"

namespace knitmech::study {

/// What the section [measured] of a study file says; empty without it. Paths are relative to the file's folder.
/// @throws model::CaseFileError
[[nodiscard]] std::optional<Measured> read_measured(const StudyEntries& entries);

}  // namespace knitmech::study
