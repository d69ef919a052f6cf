#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace knitmech::base {

/// A text in double quotes for a message: control characters become "?", and what is longer than 60 bytes is cut.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Text as it may stand in HTML, XML and SVG, also inside an attribute in double quotes; control characters, which XML
/// has no way to write, become spaces.
[[nodiscard]] std::string in_markup(std::string_view text);

/// Takes the first letter off a text in UTF-8, which is not empty; a byte that starts no letter becomes U+FFFD.
[[nodiscard]] char32_t take_letter(std::string_view& text);

/// Least number of letters to insert, delete or replace to get from one word to the other (Levenshtein distance).
[[nodiscard]] int edit_distance(std::string_view word_a, std::string_view word_b);

/// The known word that was probably meant by an unknown one: the nearest by edit distance, the first of equals.
///
/// Empty if none is near: more than a third of the letters would have to change, and more than one.
[[nodiscard]] std::string_view nearest_word(std::string_view unknown, const std::vector<std::string_view>& known);

/// "a, b or c": for messages.
[[nodiscard]] std::string alternatives(const std::vector<std::string_view>& words);

}  // namespace knitmech::base
