#pragma once

#include <filesystem>
#include <string>

#include "compare/comparison.h"
#include "compare/measured_curve.h"
#include "compare/simulated_curve.h"

namespace knitmech::app {

/// All that `compare` has to tell.
struct ComparedRun {
  std::string run;  ///< its folder
  compare::SimulatedCurve simulated;
  compare::SpecimenFacts facts;
  compare::MeasuredCurve measured;
  compare::Comparison comparison;

  /// Whether forces of specimens and fabric can be compared as they are; else only per width.
  [[nodiscard]] bool same_width() const { return facts.width == simulated.width && !measured.per_width; }
};

/// What `compare` prints of its result.
[[nodiscard]] std::string compare_text(const ComparedRun& compared);

/// compare.json, which `compare --json` prints as well; the units are in the keys.
[[nodiscard]] std::string compare_json(const ComparedRun& compared, const std::filesystem::path& folder);

}  // namespace knitmech::app
