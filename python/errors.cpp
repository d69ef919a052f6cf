#include "base/errors.h"

#include <pybind11/pybind11.h>

#include <exception>
#include <system_error>

#include "model/case_file.h"
#include "python/bindings.h"
#include "python/mistakes.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;

/// Sets the Python exception of a name in knitmech/errors.py, made from one argument.
void raise(const char* name, const py::object& argument) {
  const py::object type = py::module_::import("knitmech.errors").attr(name);
  PyErr_SetObject(type.ptr(), type(argument).ptr());
}

void translate(const std::exception_ptr& thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const model::CaseFileError& error) {
    raise("CaseError", py::make_tuple(mistake_of(error)));
  } catch (const InputError& error) {
    raise("InputError", text_of(error.what()));
  } catch (const FileError& error) {
    raise("FileError", text_of(error.what()));
  } catch (const std::system_error& error) {
    // The standard library's own, for instance a folder that may not be looked into.
    raise("FileError", text_of(error.what()));
  }
}

}  // namespace

py::str text_of(std::string_view bytes) {
  PyObject* text = PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace");
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

py::object mistake_of(const model::CaseFileError& error) {
  const py::object key = error.key().empty() ? py::object(py::none()) : text_of(error.key());
  const py::object line = error.line() > 0 ? py::object(py::int_(error.line())) : py::none();
  return py::module_::import("knitmech.errors")
      .attr("Mistake")(key, line, text_of(error.complaint()), text_of(error.what()));
}

void register_errors() {
  // pybind11 asks for a function with this parameter.
  // NOLINTNEXTLINE(performance-unnecessary-value-param)
  py::register_exception_translator([](std::exception_ptr thrown) { translate(thrown); });
}

}  // namespace knitmech::python
