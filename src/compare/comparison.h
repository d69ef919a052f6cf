#pragma once

#include <optional>
#include <vector>

#include "compare/knot_fit.h"
#include "compare/simulated_curve.h"
#include "yarn/yarn_test.h"

namespace knitmech::compare {

/// What is asked for beyond the curves.
struct ComparisonSettings {
  std::vector<double> at{};   ///< strains at which the difference is told [-]; empty: the quarters of the common range
  double offset = 0;          ///< [-], see Comparison
  bool finds_offset = false;  ///< takes the offset with the least rms_ratio in place of the given one
};

/// Both curves at one strain, forces per width.
struct DifferenceAt {
  double strain = 0;                         ///< [-]
  double simulated = 0;                      ///< [N/mm]
  double mean = 0, lowest = 0, highest = 0;  ///< measured [N/mm]
  double difference = 0;                     ///< simulated less mean [N/mm]
  std::optional<double> ratio{};             ///< the same over the mean [-]; none where the mean is not positive
};

/// A simulated curve beside the mean of measured ones, force per width over strain, on the strains that both have.
///
/// The measured force at the strain e + offset is compared with the simulated one at e: a positive offset takes away as
/// much slack of the specimens.
struct Comparison {
  std::vector<double> strains;                ///< common grid, evenly spaced, those of the simulation [-]
  std::vector<double> simulated;              ///< [N/mm]
  std::vector<double> mean, lowest, highest;  ///< measured [N/mm]
  int n_specimens = 0;
  double offset = 0;         ///< [-]
  double rms = 0;            ///< root of the mean over the strain of (simulated - mean)^2 [N/mm]
  double largest_force = 0;  ///< of the mean, in common [N/mm]
  double rms_ratio = 0;      ///< rms over largest_force [-]
  /// Share of the strains at which the simulated force is between the lowest and the highest; none of one specimen.
  std::optional<double> share_in_range{};
  std::vector<DifferenceAt> at;
  KnotFit simulated_fit, measured_fit;           ///< over the common strains
  double simulated_work = 0, measured_work = 0;  ///< integral of the force per width over the strain [mJ/mm^2]
};

/// @param simulated of the run; its forces are taken over its width
/// @param measured forces per width [N/mm]
/// Throws InputError if the curves have no strains in common, if there is no force in what they have in common, or if a
/// strain of settings.at is not in it.
[[nodiscard]] Comparison compare(const SimulatedCurve& simulated, const yarn::MeanCurve& measured,
                                 const ComparisonSettings& settings);

}  // namespace knitmech::compare
