#include "python/values.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "base/quantity.h"
#include "model/edit_case.h"
#include "python/mistakes.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;

py::object item_of(const model::TomlItem& item) {
  if (const auto* text = std::get_if<std::string>(&item)) return text_of(*text);
  if (const auto* whole = std::get_if<std::int64_t>(&item)) return py::int_(*whole);
  if (const auto* number = std::get_if<double>(&item)) return py::float_(*number);
  return text_of(std::get<model::TomlOther>(item).type);
}

py::object number_of(double number, base::Dimension dimension) {
  if (dimension == base::Dimension::number) return py::float_(number);
  return text_of(base::format_quantity(number, dimension));
}

}  // namespace

py::object value_of(const model::TomlValue& value) {
  if (const auto* items = std::get_if<std::vector<model::TomlItem>>(&value)) {
    py::list list;
    for (const model::TomlItem& item : *items) list.append(item_of(item));
    return list;
  }
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return py::int_(*whole);
  if (const auto* number = std::get_if<double>(&value)) return py::float_(*number);
  return text_of(model::typed_text(value));
}

py::object value_of(const model::Parameter& parameter, const model::Value& value) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    py::list list;
    for (const double number : *numbers) list.append(number_of(number, parameter.dimension));
    return list;
  }
  if (std::holds_alternative<std::monostate>(value)) {
    return parameter.need == model::Need::automatic ? py::object(py::str("auto")) : py::none();
  }
  if (const auto* number = std::get_if<double>(&value)) return number_of(*number, parameter.dimension);
  if (const auto* whole = std::get_if<int>(&value)) return py::int_(*whole);
  return text_of(std::get<std::string>(value));
}

}  // namespace knitmech::python
