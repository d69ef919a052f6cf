#pragma once

namespace knitmech::report {

/// The style of all pages, CSS: the file style.css, which the build makes a part of the program.
extern const char* const kStyle;

}  // namespace knitmech::report
