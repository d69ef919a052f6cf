#pragma once

#include <pybind11/pybind11.h>

#include <string_view>

#include "model/case_file.h"

namespace knitmech::python {

/// Text for Python; bytes of a user's file that are no UTF-8 become replacement characters.
[[nodiscard]] pybind11::str text_of(std::string_view bytes);

/// A mistake in a case as knitmech.errors.Mistake.
[[nodiscard]] pybind11::object mistake_of(const model::CaseFileError& error);

}  // namespace knitmech::python
