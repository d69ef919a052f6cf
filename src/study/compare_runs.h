#pragma once

#include <filesystem>

#include "compare/comparison.h"
#include "study/study.h"

namespace knitmech::study {

/// A run beside the measured curves of its study.
/// @throws FileError, InputError like compare::read_measured_curve() and compare::compare()
[[nodiscard]] compare::Comparison compare_run(const std::filesystem::path& run_folder, const Measured& measured);

}  // namespace knitmech::study
