#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/frame.h"

namespace knitmech::results {

/// The largest value of one section result: by magnitude, with its sign.
struct SectionPeak {
  double value = 0;
  int frame = 0;            ///< index of the frame
  double strain = 0;        ///< [-], of that frame
  std::size_t element = 0;  ///< by its first node

  template <class Archive>
  void serialize(Archive& archive) {
    archive(value, frame, strain, element);
  }
};

/// A section result of which the largest value is kept: its name in summary.json, and where frames have it.
struct PeakField {
  const char* key;
  std::vector<double> model::Frame::*values;
};
inline constexpr std::array<PeakField, 6> kPeakFields = {{{"axial_force_N", &model::Frame::axial_force},
                                                          {"shear_force_N", &model::Frame::shear_force},
                                                          {"bending_moment_Nmm", &model::Frame::bending_moment},
                                                          {"torque_Nmm", &model::Frame::torque},
                                                          {"axial_strain", &model::Frame::axial_strain},
                                                          {"curvature_per_mm", &model::Frame::curvature}}};

/// One entry per field of kPeakFields; empty as long as all values were zero.
using SectionPeaks = std::array<std::optional<SectionPeak>, kPeakFields.size()>;

/// Takes the values of one more frame into account. Among equal values the first stays; what is not a number is passed
/// over.
void update(SectionPeaks& peaks, const model::Frame& frame);

}  // namespace knitmech::results
