#pragma once

#include "picture/camera.h"
#include "picture/image.h"
#include "picture/text.h"
#include "picture/yarn_field.h"

namespace knitmech::picture {

/// Steps between the numbers of a colour bar, about.
inline constexpr int kColourBarIntervals = 5;

/// Draws an upright colour bar with its numbers to the right and its label above, into the left part of an area.
void draw_colour_bar(Image& image, const Area& area, const YarnField& field, const Font& font);

/// Width that the bar, its numbers and its label need [px].
[[nodiscard]] int colour_bar_width(const YarnField& field, const Font& font);

}  // namespace knitmech::picture
