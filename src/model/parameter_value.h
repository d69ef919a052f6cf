#pragma once

#include "model/parameters.h"
#include "model/toml_entries.h"

namespace knitmech::model {

/// The value of a parameter from what a case file gives for it, checked.
///
/// @throws InputError that says what is wrong with the value and shows an example; where it stands is for the caller to
/// add
[[nodiscard]] Value value_from(const Parameter& parameter, const TomlValue& given);

/// The same, but it may lie outside the range of the parameter, or be none of its choices: see complaint_about().
[[nodiscard]] Value unchecked_value_from(const Parameter& parameter, const TomlValue& given);

}  // namespace knitmech::model
