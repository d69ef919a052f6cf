#include <pybind11/pybind11.h>

#include "base/quantity.h"
#include "model/parameters.h"
#include "python/bindings.h"
#include "python/mistakes.h"
#include "python/values.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;

const char* name_of(model::Need need) {
  switch (need) {
    case model::Need::required:
      return "required";
    case model::Need::defaulted:
      return "defaulted";
    case model::Need::automatic:
      return "automatic";
    case model::Need::optional:
      break;
  }
  return "optional";
}

bool has_range(const model::Parameter& parameter) {
  const model::Kind kind = model::kind_of(parameter);
  return kind != model::Kind::text && kind != model::Kind::choice;
}

/// An end of the range of a number, a whole one where the parameter is a count.
py::object range_end(const model::Parameter& parameter, double value) {
  if (!has_range(parameter)) return py::none();
  if (model::kind_of(parameter) == model::Kind::whole_number) return py::int_(static_cast<long>(value));
  return value_of(parameter, model::Value(value));
}

py::object default_of(const model::Parameter& parameter) {
  if (parameter.need == model::Need::defaulted) return value_of(parameter, parameter.value);
  return value_of(parameter, model::Value());
}

py::dict parameter_of(const model::Parameter& parameter) {
  py::list units, choices;
  for (const base::Unit& unit : base::units_of(parameter.dimension)) units.append(text_of(unit.name));
  for (const std::string_view choice : parameter.choices) choices.append(text_of(choice));
  py::dict result;
  result["key"] = text_of(parameter.key);
  result["symbol"] = text_of(parameter.symbol);
  result["help"] = text_of(parameter.help);
  result["units"] = py::tuple(units);
  result["need"] = name_of(parameter.need);
  result["default"] = default_of(parameter);
  result["example"] = value_of(parameter, parameter.value);
  result["least"] = range_end(parameter, parameter.range.least);
  result["least_excluded"] = has_range(parameter) && parameter.range.least_excluded;
  result["greatest"] = range_end(parameter, parameter.range.greatest);
  result["choices"] = py::tuple(choices);
  return result;
}

py::list all_parameters() {
  py::list list;
  for (const model::Parameter& parameter : model::parameters()) list.append(parameter_of(parameter));
  return list;
}

}  // namespace

void bind_parameters(py::module_& module) {
  module.def("parameters", &all_parameters);
}

}  // namespace knitmech::python
