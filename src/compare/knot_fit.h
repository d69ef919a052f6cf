#pragma once

#include <optional>
#include <span>

namespace knitmech::compare {

/// Two straight lines that meet in a knot: what a force-strain curve is described by from its shape alone, measured or
/// simulated.
struct KnotFit {
  double initial_slope = 0;                ///< [N/mm] per unit of strain, before the knot
  double locked_slope = 0;                 ///< [N/mm] per unit of strain, after it
  double knot = 0;                         ///< strain of the knot [-]
  std::optional<double> locking_strain{};  ///< the knot, if the slope grows there by kLeastLocking or more
  double rms = 0;                          ///< of the residual [N/mm]
};

/// The continuous piecewise-linear least-squares fit with one free knot k,
///
///     F = a + b e + c max(0, e - k),
///
/// a, b and c by linear least squares for each k, and k the one with the least residual; it keeps kKnotMargin of the
/// strains away from both ends. The slopes are b and b + c. They depend on how far the curve goes: compare only fits
/// over the same strains.
/// @param strains ascending, evenly spaced, at least 5 @param forces as many
[[nodiscard]] KnotFit fit_knot(std::span<const double> strains, std::span<const double> forces);

}  // namespace knitmech::compare
