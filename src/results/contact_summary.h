#pragma once

#include <optional>
#include <vector>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::results {

/// The contacts of one instant in a few numbers.
struct ContactSummary {
  int contacts = 0;
  double normal_force = 0;               ///< [N], summed over the contacts
  std::optional<double> slipping_share;  ///< [-], contacts that slip over all; empty without contacts
  double elastic_slip = 0;               ///< [mm], largest of all contacts
  double elastic_slip_ratio = 0;  ///< [-], largest elastic slip over the diameter of the thinner of the two yarns

  template <class Archive>
  void serialize(Archive& archive) {
    archive(contacts, normal_force, slipping_share, elastic_slip, elastic_slip_ratio);
  }
};

/// Sums up the contacts of a frame of the model. A yarn without diameter counts as having no elastic slip ratio.
///
/// Every contact must name yarns of the model.
[[nodiscard]] ContactSummary summarise_contacts(const model::Model& model,
                                                const std::vector<model::ContactRecord>& contacts);

}  // namespace knitmech::results
