#pragma once

#include <span>
#include <string>
#include <vector>

#include "yarn/axial_law.h"
#include "yarn/tensile_curve.h"

namespace knitmech::yarn {

/// The largest force of a tensile test and where it was reached.
struct Break {
  double force = 0;   ///< [N]
  double strain = 0;  ///< [-]
};

/// A tensile test up to its break, strains ascending: what is averaged and fitted.
///
/// The break is the first point with the largest force; what follows is the fall of the force after it. Points whose
/// strain does not exceed all strains before them (a noisy or coarse strain) are left out; the last point has the
/// largest force. Throws InputError with the name of the curve if the largest force is not above 0, or if the strain
/// does not get on up to it by more than half of the range it covers: it runs backwards, or the columns are mixed up.
[[nodiscard]] TensileCurve up_to_break(const TensileCurve& curve);

/// The same curve with its strain counted from the first point from which on, up to the break, the force stays at
/// `least_force` [N] or above; points before it are left out. Takes away a slack start, or a wait before the test.
/// Throws InputError with the name of the curve if less than two points remain.
[[nodiscard]] TensileCurve without_slack(const TensileCurve& curve, double least_force);

/// The last point of a curve from up_to_break().
[[nodiscard]] Break break_of(const TensileCurve& curve);

/// Force at a strain by linear interpolation; the nearer end's force outside the curve [N].
/// @param strains ascending, at least one @param forces as many [N]
[[nodiscard]] double force_at(std::span<const double> strains, std::span<const double> forces, double strain);

/// The mean of several tensile tests on common strains.
struct MeanCurve {
  int n_curves = 0;
  std::vector<double> strains;   ///< evenly spaced [-]
  std::vector<double> forces;    ///< mean over all curves [N]
  std::vector<double> least;     ///< least force of the curves [N]
  std::vector<double> greatest;  ///< greatest force of the curves [N]
};

/// Mean, least and greatest force from the strain where the last of the curves begins, but not below 0, to that where
/// the first of them breaks, so that every curve counts everywhere.
/// @param curves from up_to_break(), at least one
/// Throws InputError if the curves have no strains in common.
[[nodiscard]] MeanCurve mean_of(std::span<const TensileCurve> curves);

struct StrainRange {
  double from = 0;  ///< [-]
  double to = 0;    ///< [-]
};

/// Straight line N = intercept + slope * strain, fitted to a curve by least squares.
struct LineFit {
  double slope = 0;      ///< EA [N]; E is this over the area
  double intercept = 0;  ///< force at strain 0 [N]; small against the forces of the range if the yarn is linear there
  double r_squared = 0;  ///< 1 less the residual's share in the variance of the force [-]
  double rms_ratio = 0;  ///< root mean square of the residual over the largest force of the range [-]
  StrainRange range;     ///< the part of the wanted range that the curve covers
  bool covers = true;    ///< that is the whole wanted range, but for a hundredth
};

/// Fits a line to the curve at evenly spaced strains of the range, or of the part of it that the curve covers.
///
/// The line has an intercept, so that a wrong zero of force or strain (slack, pre-tension) does not turn it.
/// Throws InputError if the curve has no strains in the range, or no force that rises over it.
[[nodiscard]] LineFit fit_line(std::span<const double> strains, std::span<const double> forces, StrainRange wanted);

/// Points for AxialLaw along a mean curve: 33 at even strains from 0 to its end.
///
/// The model's yarn is free of force at strain 0; therefore the force of the mean curve at strain 0 (a pre-tension) is
/// taken off. Between the ends each force is the mean over half a spacing to either side, and where it still falls,
/// forces are pooled until it does not (isotonic regression by pooling adjacent violators). All numbers are rounded to
/// six digits. Throws InputError if the force does not rise from strain 0.
[[nodiscard]] std::vector<AxialPoint> law_points(const MeanCurve& mean);

/// A finite number rounded to six significant digits, more than any testing machine knows.
[[nodiscard]] double six_digits(double value);

}  // namespace knitmech::yarn
