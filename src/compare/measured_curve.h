#pragma once

#include <optional>
#include <string>
#include <vector>

#include "yarn/tensile_curve.h"
#include "yarn/yarn_test.h"

namespace knitmech::compare {

/// What is known of measured fabrics besides their files. All specimens have the same gauge length and width.
struct SpecimenFacts {
  double gauge_length = 0;             ///< [mm], turns displacements into strains
  double width = 0;                    ///< [mm], turns forces into forces per width
  yarn::ColumnChoice columns{};        ///< which to take where their names do not tell
  std::vector<std::string> samples{};  ///< names of the specimens to take; empty: all
};

/// Force per width over strain of several specimens, averaged.
struct MeasuredCurve {
  std::vector<yarn::TensileCurve> specimens;  ///< each up to its largest force, in N
  /// Mean, least and greatest force per width [N/mm] where all specimens are, see yarn::mean_of().
  yarn::MeanCurve mean;
  bool per_width = false;  ///< a file tells forces per width
};

/// The curves of fabrics in text files, as yarn::read_tensile_curves() reads them, with force (N, mN, cN, kgf, ...) or
/// force per width (N/mm, N/m, N/cm, gf/cm, ...) over displacement or strain.
///
/// Each ends with its largest force; points whose strain does not exceed all before them are left out.
/// @param files at least one
/// Throws FileError if a file cannot be read, and InputError with file, line and what would be right if it is no such
/// table, if no specimen has a wanted name, or if the specimens have no strains in common.
[[nodiscard]] MeasuredCurve read_measured_curve(const std::vector<std::string>& files, const SpecimenFacts& facts);

/// The same of curves that were read. @param width [mm], of all specimens
[[nodiscard]] MeasuredCurve average(std::vector<yarn::TensileCurve> specimens, double width);

}  // namespace knitmech::compare
