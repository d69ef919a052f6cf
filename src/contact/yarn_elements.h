#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/vectorise.h"
#include "model/model.h"

namespace knitmech::contact {

/// The yarns as contact sees them, element by element; one entry per node, as in model::Model.
struct YarnElements {
  std::vector<std::int32_t> yarn;     ///< of the node
  std::vector<std::int32_t> section;  ///< of the element, index into Model::sections: the kind of yarn
  std::vector<std::uint8_t> exists;   ///< 1 where an element starts
  std::vector<double> radius;         ///< of the element [mm]
  std::vector<double> length;         ///< [mm], of the element along the stress-free yarn
  std::vector<double> before;         ///< [mm], along the stress-free yarn from its first node to this one
  std::vector<double> after;          ///< [mm], from this node to the yarn's last
  double shortest = 0;                ///< element [mm]

  [[nodiscard]] std::size_t n_nodes() const { return yarn.size(); }
  [[nodiscard]] bool has_previous(std::size_t element) const { return element > 0 && exists[element - 1] != 0; }
  [[nodiscard]] bool has_next(std::size_t element) const {
    return element + 1 < exists.size() && exists[element + 1] != 0;
  }
};

[[nodiscard]] YarnElements make_yarn_elements(const model::Model& model);

using YarnPlace = model::ElementPlace;

/// Arc length along the stress-free yarn from its first node [mm].
[[nodiscard]] inline double arc_of(const YarnElements& elements, YarnPlace place) {
  const auto element = static_cast<std::size_t>(place.element);
  return elements.before[element] + place.share * elements.length[element];
}

/// Distance along the yarn from a place to its nearer end [mm]; not above 0 at the end itself.
KNITMECH_INLINE double to_nearer_end(const YarnElements& elements, YarnPlace place) {
  const auto element = static_cast<std::size_t>(place.element);
  const double along = place.share * elements.length[element];
  return std::min(elements.before[element] + along, elements.after[element] - along);
}

/// The same place when the share lies beyond the element: on the element there, or held at the yarn's end.
KNITMECH_INLINE YarnPlace walk(const YarnElements& elements, YarnPlace place) {
  auto element = static_cast<std::size_t>(place.element);
  double share = place.share;
  while (share > 1) {
    if (!elements.has_next(element)) {
      share = 1;
      break;
    }
    share = (share - 1) * elements.length[element] / elements.length[element + 1];
    ++element;
  }
  while (share < 0) {
    if (!elements.has_previous(element)) {
      share = 0;
      break;
    }
    share = 1 + share * elements.length[element] / elements.length[element - 1];
    --element;
  }
  return {static_cast<std::int32_t>(element), share};
}

}  // namespace knitmech::contact
