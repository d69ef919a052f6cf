#pragma once

#include <optional>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::results {

/// A stored frame in a few numbers: how far the fabric leaves its plane, and in which part of its width yarns press on
/// each other.
struct FrameMeasures {
  int index = 0;
  double strain = 0;                         ///< [-]
  double lowest_z = 0, highest_z = 0;        ///< [mm], of the yarns' centrelines
  int contacts = 0;                          ///< with a force
  std::optional<double> contacts_in_middle;  ///< [-], share of the contacts in the middle third of the width
  std::optional<double> force_in_middle;     ///< [-], share of their normal forces there; a third if spread evenly

  template <class Archive>
  void serialize(Archive& archive) {
    archive(index, strain, lowest_z, highest_z, contacts, contacts_in_middle, force_in_middle);
  }
};

/// Measures a frame. The middle third is that of the fabric's extent across the pull, in the same frame. Shares are
/// empty without contacts; nodes whose position is not finite are left out.
[[nodiscard]] FrameMeasures measure_frame(const model::Frame& frame);

}  // namespace knitmech::results
