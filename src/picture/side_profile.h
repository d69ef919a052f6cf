#pragma once

#include <string>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::picture {

/// The fabric from the side as an SVG document: z, out of plane, over y, along the pull, in mm. All centrelines are
/// thin lines; two thick ones are the lowest and the highest z of any centreline within each step of y. The axes are
/// stretched against each other, and a note says by how much.
///
/// \param caption line above, UTF-8
/// Throws InputError if the frame has no yarn whose position is known.
[[nodiscard]] std::string side_profile_svg(const model::Model& model, const model::Frame& frame,
                                           const std::string& caption);

}  // namespace knitmech::picture
