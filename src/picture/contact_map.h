#pragma once

#include <string>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::picture {

/// The contacts of a frame as a map, an SVG document: the yarns from the front as thin grey lines over axes in mm, in
/// true proportions, and each contact as a disc at its place. The area of a disc is proportional to the normal force;
/// its colour, and the ring of those that slip, tell whether it sticks or slips. A legend has both with their numbers,
/// and a disc of a round force.
///
/// \param caption line above the map, UTF-8
/// Throws InputError if the frame has no yarn whose position is known.
[[nodiscard]] std::string contact_map_svg(const model::Model& model, const model::Frame& frame,
                                          const std::string& caption);

}  // namespace knitmech::picture
