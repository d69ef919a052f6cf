#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "yarn/fineness.h"
#include "yarn/yarn_test.h"

namespace knitmech::app {

/// What `knitmech yarn` finds in its files.
struct YarnAnalysis {
  std::vector<yarn::TensileCurve> curves;  ///< up to the break, one of each specimen
  std::vector<double> slopes;              ///< EA of each [N], over the range of the fit
  yarn::MeanCurve mean;
  yarn::Break mean_break;  ///< mean of the largest forces and of their strains
  yarn::LineFit fit;       ///< of the mean curve
  yarn::Fineness fineness;
  std::optional<double> poissons_ratio;  ///< as given
  std::vector<yarn::AxialPoint> law;     ///< empty unless the measured curve is asked for
  std::vector<std::string> warnings;

  /// E of the fit [MPa]; empty without a diameter.
  [[nodiscard]] std::optional<double> youngs_modulus() const;
};

/// Reads the files and evaluates them.
///
/// @throws InputError for wrong options and files, FileError if a file cannot be read
[[nodiscard]] YarnAnalysis analyse_yarn(const YarnOptions& options);

}  // namespace knitmech::app
