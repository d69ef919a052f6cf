#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "model/yarn_curve.h"

namespace knitmech::exchange {

/// A point of a smooth yarn centreline.
struct YarnSample {
  Eigen::Vector3d point;    ///< [mm]
  Eigen::Vector3d tangent;  ///< unit
  std::size_t piece = 0;    ///< index of its element in the row that was sampled
  double parameter = 0;     ///< along the element, 0 to 1
};

/// Elements that follow each other without a gap: one yarn, or what lies between two breaks of it.
using YarnRow = std::span<const model::CurvePiece>;

/// The rows of the pieces of model::yarn_curves(), in their order.
[[nodiscard]] std::vector<YarnRow> yarn_rows(const std::vector<model::CurvePiece>& pieces);

/// Into how many equal steps of the parameter an element is cut, so that no chord is farther than kChordErrorShare of
/// the yarn's radius from the centreline: sqrt(h / (8 kChordErrorShare r)) rounded up, where h is the largest second
/// derivative, which on a cubic is that at one of the ends. From 1 to kMostStepsPerElement.
[[nodiscard]] int steps_of(const model::CurvePiece& piece);

/// The points of a row at those steps, its two ends among them; neighbouring elements share theirs.
[[nodiscard]] std::vector<YarnSample> samples_of(YarnRow row);

/// The same with a given number of steps in each element.
[[nodiscard]] std::vector<YarnSample> samples_of(YarnRow row, int steps);

/// The direction across the curve at the next sample that is turned least about the tangent: two reflections, one onto
/// the next point, one onto its tangent (W. Wang, B. Juettler, D. Zheng, Y. Liu, "Computation of rotation minimizing
/// frames", ACM Transactions on Graphics 27, 2008). across: unit, across `from`.
[[nodiscard]] Eigen::Vector3d carried_across(const Eigen::Vector3d& across, const YarnSample& from,
                                             const YarnSample& to);

}  // namespace knitmech::exchange
