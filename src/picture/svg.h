#pragma once

#include <string>

namespace knitmech::picture {

/// Pieces of SVG documents; lengths and places in px from the upper left corner, rounded to 0.01 px.

/// A text, whatever is in it. anchor: "start", "middle" or "end", which lies at x; more: further attributes, each with
/// a space before it.
[[nodiscard]] std::string text_element(double x, double y, double size, const char* anchor, const std::string& text,
                                       const std::string& more = {});

[[nodiscard]] std::string line_element(double x1, double y1, double x2, double y2, const char* attributes);

/// A whole document of elements on white.
[[nodiscard]] std::string svg_document(int width, int height, const std::string& elements);

}  // namespace knitmech::picture
