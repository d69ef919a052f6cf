#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "model/model.h"

namespace knitmech::results {

/// Where an element lies, in the words of the fabric; course and wale count from 1 at the bottom left.
struct YarnPlace {
  int yarn = 0;             ///< index into Model::yarns
  int course = 0;           ///< 0 where the stitches are not known, Model::has_stitches
  std::optional<int> wale;  ///< empty on a turning arc
  std::string
      part;  ///< "head", "leg", "foot", or "turning arc", that from its course to the next; empty without stitches
  double arc_length = 0;  ///< [mm], of the element's middle, from the yarn's first node along the stress-free yarn
};

/// The place of the element that starts at a node. An element of which both ends run in the same direction in plan, and
/// not along the course, lies on a leg; any other belongs to the head or the foot, by its height in the course.
/// element: an index below Model::n_nodes() that is not the last of its yarn.
[[nodiscard]] YarnPlace place_of_element(const model::Model& model, std::size_t element);

}  // namespace knitmech::results
