#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/frame.h"

namespace knitmech::results {

/// A part of the force-strain curve in which the fabric gives in one way.
struct CurveStage {
  std::string name;                         ///< "toe", "bending" or "stretching"
  double from = 0, to = 0;                  ///< strains [-]
  std::optional<double> slope{};            ///< [N] per unit of strain, of the least-squares line through its rows
  std::optional<double> slope_per_width{};  ///< [N/mm] per unit of strain, the same over the width at the start
};

/// The stages of a simulated curve, told by where its energy is, not by its shape:
///
/// - toe: the loops slide and close, next to no energy is in the yarns. It ends where the strain energy first reaches
///   kToeEnergy times model::bending_measure();
/// - bending: the loops are drawn straight and round each other; bending and twist take up more of the growing strain
///   energy than stretch does;
/// - stretching: d(stretch energy) / d(strain) exceeds d(the rest of the strain energy) / d(strain), both over kWindow
///   of strain, from there to the end of the curve, which is at least kWindow away.
///
/// So the limits do not move when the test goes on further, unless a stretching that had begun gives way again. The
/// curve ends where the first yarn breaks.
struct CurveStages {
  std::vector<CurveStage> stages;  ///< those that the test reached, in order, each from the end of the one before
  std::optional<double> bending_strain{};  ///< [-], where the toe ends; empty: the test ends before
  std::optional<double> stretch_strain{};  ///< [-], where stretching begins; empty: the test ends before
  /// Share of stretch in the growth of the strain energy over the last kWindow of the curve [-]; empty in the toe or if
  /// the energy does not grow. Beyond 0.5 the yarn stretches.
  std::optional<double> stretch_share{};
};

/// Never throws; a history without rows has no stages.
/// @param bending_measure [mJ], of the model
[[nodiscard]] CurveStages curve_stages(const std::vector<model::HistoryRow>& history, double bending_measure);

}  // namespace knitmech::results
