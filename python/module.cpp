#include <pybind11/pybind11.h>

#include "python/bindings.h"

PYBIND11_MODULE(_core, module) {
  namespace python = knitmech::python;
  module.doc() = "The compiled part of knitmech; see the package for what to use.";
  module.attr("__version__") = KNITMECH_VERSION;
  python::register_errors();
  python::bind_parameters(module);
  python::bind_case(module);
  python::bind_model(module);
  python::bind_frame(module);
  python::bind_run(module);
  python::bind_export(module);
}
