#pragma once

#include <optional>
#include <vector>

#include "model/frame.h"

namespace knitmech::results {

/// What is read off a force-strain curve at one strain. "Per width" is per width of the fabric at the start.
struct CurveMeasure {
  double strain = 0;                       ///< [-]
  double force = 0;                        ///< [N], mean of both grips
  double force_per_width = 0;              ///< [N/mm]
  std::optional<double> secant{};          ///< [N/mm] per unit of strain: force per width over strain; none at strain 0
  std::optional<double> tangent{};         ///< [N/mm] per unit of strain, of the curve at this strain
  double width = 0;                        ///< w [mm], at mid-height
  double contraction = 0;                  ///< -(w - w0) / w0 [-]
  std::optional<double> poissons_ratio{};  ///< contraction over strain [-]; none at strain 0
};

/// Pull on the fabric [N]: the mean of both grips, which takes the first wave that runs between them out.
[[nodiscard]] double curve_force(const model::HistoryRow& row);

/// The measures at a strain: linear between the rows, the tangent that of the least-squares line through the rows
/// within kWindow / 2 to either side and at least the neighbours. Empty if the history does not reach the strain.
[[nodiscard]] std::optional<CurveMeasure> measure_at(const std::vector<model::HistoryRow>& history, double strain);

/// The measures at every row: the Poisson contraction, the stiffness per width and so on as curves.
[[nodiscard]] std::vector<CurveMeasure> curve_measures(const std::vector<model::HistoryRow>& history);

}  // namespace knitmech::results
