#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/model.h"

namespace knitmech::model {

/// The yarn that a node belongs to, index into Model::yarns.
[[nodiscard]] int yarn_of_node(const Model& model, std::size_t node);

/// The yarns in the pieces that broken elements leave of them, in the order of their nodes. A piece may be one node.
/// \param broken elements, each by its first node, in any order
[[nodiscard]] std::vector<ModelYarn> pieces_of_yarns(const Model& model, const std::vector<int>& broken);

/// The node of a yarn nearest to an arc length from its first node [mm].
[[nodiscard]] std::size_t node_near(const Model& model, int yarn, double arc_length);

/// Length of yarn in the whole fabric [mm].
[[nodiscard]] double yarn_length_of(const Model& model);

/// Highest minus lowest y of the centreline before the test [mm].
[[nodiscard]] double height_of(const Model& model);

/// "left" or "right": the side of the fabric on which a node lies before the test.
[[nodiscard]] std::string side_of(const Model& model, std::size_t node);

/// "course 3, wale 4", or "the turning arc of courses 3 and 4", for messages; courses and wales counted from 1. "yarn
/// 3" where the stitches are not known.
[[nodiscard]] std::string place_text(const Model& model, std::size_t node);

/// Where an element lies: "course 3, wale 4, 12.3 mm along the yarn", or on "the turning arc of ...", for messages; the
/// length is that of its middle from the yarn's first node. element: by its first node.
[[nodiscard]] std::string element_text(const Model& model, std::size_t element);

}  // namespace knitmech::model
