#pragma once

#include <string>
#include <string_view>

#include "model/parameters.h"
#include "model/toml_entries.h"

namespace knitmech::model {

/// A value of a file as a person types it into a field: 7 mm, 0.1, basic, 0.08, 0.16.
[[nodiscard]] std::string typed_text(const TomlValue& value);

/// A value of a case in the same way; "auto" where the program chooses it, empty for one that is not given.
[[nodiscard]] std::string typed_text(const Parameter& parameter, const Value& value);

/// What a person types for a parameter as it is written in a case file: "7 mm" with its quotes, 0.1, [0.08, 0.16].
/// What cannot be meant becomes a text in quotes, for the reader of the case to complain about.
[[nodiscard]] std::string toml_of_typed(const Parameter& parameter, std::string_view typed);

/// The text of a case file with another value for one key; everything else, comments included, stays as it is.
///
/// A key that is not there is put where a line with "#" before it holds its place, or else behind the keys that come
/// before it in the table of parameters, if need be in a new section at the end. An empty `typed` takes a key that
/// need not be given out of force by a "#" before it; a required one stays with an empty text.
/// @throws InputError if there is no such key, or if the text is no TOML, or gives the key in a way that only its
/// author can change
[[nodiscard]] std::string with_value(std::string_view text, std::string_view key, std::string_view typed);

}  // namespace knitmech::model
