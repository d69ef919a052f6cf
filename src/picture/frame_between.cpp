#include "picture/frame_between.h"

#include <algorithm>
#include <cmath>

namespace knitmech::picture {
namespace {

using model::Frame;
using model::HistoryRow;

template <typename Value>
std::vector<Value> between(const std::vector<Value>& values_a, const std::vector<Value>& values_b, double share) {
  std::vector<Value> values;
  values.reserve(values_a.size());
  for (std::size_t i = 0; i < values_a.size(); ++i) {
    values.push_back(Value((1 - share) * values_a[i] + share * values_b[i]));
  }
  return values;
}

/// Unit quaternions; q and -q are the same rotation, the nearer of them is taken.
std::vector<Eigen::Vector4d> rotations_between(const std::vector<Eigen::Vector4d>& rotations_a,
                                               const std::vector<Eigen::Vector4d>& rotations_b, double share) {
  std::vector<Eigen::Vector4d> rotations;
  rotations.reserve(rotations_a.size());
  for (std::size_t i = 0; i < rotations_a.size(); ++i) {
    const double sign = rotations_a[i].dot(rotations_b[i]) < 0 ? -1 : 1;
    rotations.emplace_back(((1 - share) * rotations_a[i] + share * sign * rotations_b[i]).normalized());
  }
  return rotations;
}

HistoryRow between(const HistoryRow& row_a, const HistoryRow& row_b, double share) {
  HistoryRow row;
  for (const auto member : {&HistoryRow::time, &HistoryRow::displacement, &HistoryRow::strain, &HistoryRow::force_top,
                            &HistoryRow::force_bottom}) {
    row.*member = std::lerp(row_a.*member, row_b.*member, share);
  }
  return row;
}

}  // namespace

Frame frame_between(const Frame& frame_a, const Frame& frame_b, double share) {
  Frame frame;
  frame.index = frame_a.index;
  frame.history = between(frame_a.history, frame_b.history, share);
  for (const auto member : {&Frame::points, &Frame::contact_force, &Frame::tie_force}) {
    frame.*member = between(frame_a.*member, frame_b.*member, share);
  }
  for (const auto member :
       {&Frame::axial_force, &Frame::shear_force, &Frame::bending_moment, &Frame::torque, &Frame::axial_strain,
        &Frame::curvature, &Frame::stretch_energy, &Frame::bending_energy, &Frame::twist_energy, &Frame::gap}) {
    frame.*member = between(frame_a.*member, frame_b.*member, share);
  }
  frame.rotations = rotations_between(frame_a.rotations, frame_b.rotations, share);
  frame.contacts = share < 0.5 ? frame_a.contacts : frame_b.contacts;
  frame.broken = share > 0 ? frame_b.broken : frame_a.broken;
  return frame;
}

HistoryRow row_at_strain(const std::vector<HistoryRow>& history, double strain) {
  const auto next = std::lower_bound(history.begin(), history.end(), strain,
                                     [](const HistoryRow& row, double value) { return row.strain < value; });
  if (next == history.begin()) return history.front();
  if (next == history.end()) return history.back();
  const HistoryRow& before = *(next - 1);
  return between(before, *next, (strain - before.strain) / (next->strain - before.strain));
}

}  // namespace knitmech::picture
