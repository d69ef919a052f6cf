#include <algorithm>
#include <cmath>

#include "curves/constants.h"
#include "curves/smooth_line.h"

namespace knitmech::curves {
namespace {

/// Length of an arc between two shares, by Gauss' rule with three points.
double length_between(const CubicArc& arc, double from, double to) {
  const double half = (to - from) / 2;
  const double middle = (from + to) / 2;
  const double off = half * std::sqrt(0.6);
  const auto speed = [&](double share) { return arc.derivative(share).norm(); };
  return half * (5 * speed(middle - off) + 8 * speed(middle) + 5 * speed(middle + off)) / 9;
}

/// The direction at a share, also where points of the file coincide and the curve stands still for a moment.
Eigen::Vector3d direction(const CubicArc& arc, double share) {
  const Eigen::Vector3d derivative = arc.derivative(share);
  const double size = (arc.corners[1] - arc.corners[0]).norm() + (arc.corners[2] - arc.corners[1]).norm() +
                      (arc.corners[3] - arc.corners[2]).norm();
  if (derivative.norm() > kStandstill * size) return derivative.normalized();
  constexpr double kBeside = 1e-3;
  return (arc.point(std::min(1.0, share + kBeside)) - arc.point(std::max(0.0, share - kBeside))).normalized();
}

}  // namespace

AlongLine::AlongLine(std::vector<CubicArc> arcs) : arcs_(std::move(arcs)), length_at_{0} {
  length_at_.reserve(arcs_.size() * kPiecesPerArc + 1);
  for (const CubicArc& arc : arcs_) {
    for (int i = 0; i < kPiecesPerArc; ++i) {
      const double from = static_cast<double>(i) / kPiecesPerArc;
      const double to = static_cast<double>(i + 1) / kPiecesPerArc;
      length_at_.push_back(length_at_.back() + length_between(arc, from, to));
    }
  }
}

AlongLine::Place AlongLine::at(double arc_length) const {
  const double sought = std::clamp(arc_length, 0.0, length());
  const auto next = std::upper_bound(length_at_.begin() + 1, length_at_.end() - 1, sought);
  const auto piece = static_cast<std::size_t>(next - length_at_.begin()) - 1;
  const CubicArc& arc = arcs_[piece / kPiecesPerArc];
  const double start = static_cast<double>(piece % kPiecesPerArc) / kPiecesPerArc;
  constexpr double kWidth = 1.0 / kPiecesPerArc;
  const double within = sought - length_at_[piece];
  const double whole = *next - length_at_[piece];
  double share = start + (whole > 0 ? kWidth * within / whole : 0);
  constexpr int kCorrections = 3;  // Newton, from a guess that is near
  for (int i = 0; i < kCorrections; ++i) {
    const double speed = arc.derivative(share).norm();
    if (!(speed > 0)) break;
    const double corrected = share + (within - length_between(arc, start, share)) / speed;
    share = std::clamp(corrected, start, start + kWidth);
  }
  return {arc.point(share), direction(arc, share)};
}

}  // namespace knitmech::curves
