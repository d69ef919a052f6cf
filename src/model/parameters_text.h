#pragma once

#include <string>
#include <string_view>

#include "model/parameters.h"

namespace knitmech::model {

/// A value as it is written in a case file: "7 mm" with its quotes, 0.1, [0.08, 0.16].
[[nodiscard]] std::string toml_text(const Parameter& parameter, const Value& value);

/// Any text as a TOML string, in double quotes.
[[nodiscard]] std::string toml_string(std::string_view text);

/// `height = "7 mm"`: for messages and case files.
[[nodiscard]] std::string assignment(const Parameter& parameter, const Value& value);

/// The example of a parameter as an assignment.
[[nodiscard]] inline std::string example_of(const Parameter& parameter) {
  return assignment(parameter, parameter.value);
}

/// A case file with a comment on every parameter: what must be given has the values of the examples, what has a default
/// stands behind "#".
[[nodiscard]] std::string case_template();

/// The input reference: every parameter with symbol, unit, default, range and meaning, as Markdown.
[[nodiscard]] std::string input_reference();

/// The same as a list for the terminal.
[[nodiscard]] std::string parameter_list();

}  // namespace knitmech::model
