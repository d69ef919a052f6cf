#pragma once

#include <pybind11/pybind11.h>

#include "model/parameters.h"
#include "model/toml_entries.h"

namespace knitmech::python {

/// A value of a case file for Python: str, int, float, or a list of these.
[[nodiscard]] pybind11::object value_of(const model::TomlValue& value);

/// A value of a parameter in the same way, a quantity with its unit as it is written in a case file: "7 mm". "auto"
/// where the program chooses it, None where it is not given.
[[nodiscard]] pybind11::object value_of(const model::Parameter& parameter, const model::Value& value);

}  // namespace knitmech::python
