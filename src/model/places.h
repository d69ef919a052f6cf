#pragma once

#include <cstddef>
#include <string>

#include "model/model.h"

namespace knitmech::model {

/// The node of a yarn nearest to an arc length from its first node [mm].
[[nodiscard]] std::size_t node_near(const Model& model, int yarn, double arc_length);

/// "left" or "right": the side of the fabric on which a node lies before the test.
[[nodiscard]] std::string side_of(const Model& model, std::size_t node);

/// "course 3, wale 4", or "the turning arc of courses 3 and 4", for messages; courses and wales counted from 1.
[[nodiscard]] std::string place_text(const Model& model, std::size_t node);

}  // namespace knitmech::model
