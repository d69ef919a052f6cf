#pragma once

#include <cstdint>
#include <vector>

#include "model/model.h"

namespace knitmech::contact {

/// What the contact needs to know of the yarns, one entry per node; element i joins nodes i and i + 1.
struct ContactElements {
  std::vector<std::int32_t> yarn;    ///< yarn of the node
  std::vector<std::uint8_t> exists;  ///< 1 where an element starts
  std::vector<double> radius;        ///< of the element [mm]
  std::vector<double> rest_length;   ///< of the element's stress-free chord [mm]
  std::vector<double> arc_length;    ///< of the node, along its yarn [mm]
  double friction = 0;               ///< mu [-]
  double stiffness = 0;              ///< K of a crossing [N/mm]
  double largest_radius = 0;         ///< [mm]

  [[nodiscard]] std::size_t n_nodes() const { return yarn.size(); }
  [[nodiscard]] bool has_previous(std::size_t element) const { return element > 0 && exists[element - 1] != 0; }
  [[nodiscard]] bool has_next(std::size_t element) const {
    return element + 1 < exists.size() && exists[element + 1] != 0;
  }
};

[[nodiscard]] ContactElements make_contact_elements(const model::Model& model);

}  // namespace knitmech::contact
