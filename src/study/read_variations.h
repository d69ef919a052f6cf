#pragma once

#include <vector>

#include "study/study.h"
#include "study/study_entries.h"

namespace knitmech::study {

/// Most values of a parameter, samples or cases of a study [-].
inline constexpr int kMostCases = 10000;

inline bool takes_samples(Plan plan) {
  return plan == Plan::latin_hypercube || plan == Plan::sobol;
}

/// The parameters that a study file varies, one for each section [loop.height], in the order of the file.
/// @throws model::CaseFileError also for all sections and keys below sections that are no parameter
[[nodiscard]] std::vector<Variation> read_variations(const StudyEntries& entries, Plan plan);

}  // namespace knitmech::study
