#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/frame.h"
#include "model/run_outcome.h"

namespace knitmech::results {

/// Whether a run may be read as a quasi-static tensile test, and the numbers behind that.
///
/// Ratios are empty when the run never left the toe region (or has no history), and infinite when their denominator is
/// zero or negative. They are taken after the toe, where forces are large enough for a ratio to mean something.
struct Quality {
  std::optional<double> toe_strain;              ///< [-], where the toe region ends
  std::optional<double> kinetic_ratio;           ///< [-], largest kinetic / internal energy over a window
  std::optional<double> kinetic_ratio_strain;    ///< [-], end of that window
  std::optional<double> energy_balance_end;      ///< [-], |balance| / external work of the last row
  std::optional<double> energy_balance;          ///< [-], largest |balance| / external work
  std::optional<double> energy_balance_strain;   ///< [-], where that is
  std::optional<double> grip_difference;         ///< [-], largest |top - bottom| / mean over a window
  std::optional<double> grip_difference_strain;  ///< [-], end of that window
  double penetration = 0;                        ///< [mm], largest of the run
  double penetration_ratio = 0;                  ///< [-], over the yarn diameter
  double elastic_slip = 0;                       ///< [mm], largest of the history
  double elastic_slip_ratio = 0;                 ///< [-], over the yarn diameter
  int lost_crossings = 0;                        ///< yarns that passed through each other
  long crossing_checks = 0;                      ///< how often all crossings were checked for that
  bool quasi_static = false;                     ///< all limits kept, no crossing lost, the simulation did not fail
  std::string verdict;  ///< one or two sentences: what holds, or which limit failed and what to try
};

/// Energy that is not accounted for [mJ]:
/// internal + kinetic + contact + friction loss + damping loss + break loss - external work.
[[nodiscard]] double energy_residual(const model::HistoryRow& row);

/// Index of the first row after the toe region; history.size() if the run never left it.
///
/// The toe region is the start of the test, in which the loops only straighten and hardly any force acts. It ends with
/// the last row whose external work is below the share kToeWorkShare of the largest work of the run; a run without
/// positive work is all toe.
[[nodiscard]] std::size_t first_row_after_toe(const std::vector<model::HistoryRow>& history);

/// Judges a run by the limits of results/constants.h: kinetic energy and difference of the grip forces, both averaged
/// over windows of kWindow strain (counted back from the end; a first window that is not full is used only if it is the
/// only one), energy balance, crossings.
///
/// diameter [mm] is that of the yarn; with 0 the relative penetration and elastic slip are 0. Works for short, empty,
/// interrupted and all-zero histories.
[[nodiscard]] Quality assess_quality(const std::vector<model::HistoryRow>& history, const model::RunOutcome& outcome,
                                     double diameter);

}  // namespace knitmech::results
