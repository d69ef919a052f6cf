#pragma once

#include <string_view>
#include <vector>

#include "picture/camera.h"
#include "picture/yarn_field.h"

namespace knitmech::picture {

/// What the words of the command line mean: "contact", "bending-moment", ...; "front", "oblique", ...
///
/// Both throw InputError with the word that was probably meant, or all of them.
[[nodiscard]] ColourBy colour_by_word(std::string_view word);
[[nodiscard]] View view_by_word(std::string_view word);

/// All words.
[[nodiscard]] std::vector<std::string_view> colour_words();
[[nodiscard]] std::vector<std::string_view> view_words();

}  // namespace knitmech::picture
