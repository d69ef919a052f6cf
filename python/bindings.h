#pragma once

#include <pybind11/pybind11.h>

namespace knitmech::python {

/// Wrong input and trouble with files as the exceptions of knitmech/errors.py.
void register_errors();

/// Each adds its functions and classes to knitmech._core; knitmech/_core.pyi says what they are to Python.
void bind_parameters(pybind11::module_& module);
void bind_case(pybind11::module_& module);
void bind_model(pybind11::module_& module);
void bind_frame(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_export(pybind11::module_& module);

}  // namespace knitmech::python
