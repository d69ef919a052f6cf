#include <pybind11/pybind11.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/text.h"
#include "model/case_file.h"
#include "model/edit_case.h"
#include "model/facts.h"
#include "model/parameter_value.h"
#include "model/parameters_text.h"
#include "python/bindings.h"
#include "python/mistakes.h"
#include "python/values.h"
#include "results/atomic_file.h"
#include "run/check_json.h"
#include "run/run_case.h"

namespace knitmech::python {
namespace {

namespace py = pybind11;

std::vector<model::TomlEntry> entries_of(const std::string& text, const std::string& name) {
  try {
    return model::toml_entries(text);
  } catch (const model::TomlSyntaxError& error) {
    throw model::CaseFileError(name, error.line(), {}, error.what());
  }
}

/// What holds for a key of the table of parameters: the value that the text gives, or else the default.
py::object value_in(const std::string& text, const std::string& name, const std::string& key) {
  const model::Parameter& parameter = *model::find_parameter(key);
  const std::vector<model::TomlEntry> entries = entries_of(text, name);
  const auto entry = std::ranges::find(entries, key, &model::TomlEntry::key);
  if (entry != entries.end()) return value_of(entry->value);
  return value_of(parameter, parameter.need == model::Need::defaulted ? parameter.value : model::Value());
}

py::list given_keys(const std::string& text, const std::string& name) {
  py::list keys;
  for (const model::TomlEntry& entry : entries_of(text, name)) {
    if (!std::holds_alternative<model::TomlSection>(entry.value)) keys.append(text_of(entry.key));
  }
  return keys;
}

/// The text with another value for a key of the table, which must be allowed by itself.
std::string with_value(const std::string& text, const std::string& name, const std::string& key,
                       const std::string& typed) {
  static_cast<void>(entries_of(text, name));  // whose mistakes have a line
  const bool is_required = model::find_parameter(key)->need == model::Need::required;
  if (typed.empty() && is_required)
    throw model::CaseFileError(name, model::line_of_key(text, key), key, "must be given");
  std::string changed = model::with_value(text, key, typed);
  const std::vector<model::TomlEntry> entries = model::toml_entries(changed);
  const auto entry = std::ranges::find(entries, key, &model::TomlEntry::key);
  if (entry == entries.end()) return changed;
  try {
    static_cast<void>(model::value_from(*model::find_parameter(key), entry->value));
  } catch (const InputError& error) {
    throw model::CaseFileError(name, entry->line, key, error.what());
  }
  return changed;
}

py::list mistakes_in(const std::string& text, const std::string& name) {
  py::list list;
  for (const model::CaseFileError& error : model::mistakes_in(text, name)) list.append(mistake_of(error));
  return list;
}

std::string check_json(const std::string& text, const std::string& name) {
  const run::LoadedCase loaded = run::load_case_text(text, name);
  const model::FabricFacts facts = model::describe(loaded.input, loaded.model);
  return run::check_json(loaded, facts, *run::resolved_settings(loaded, {}).mass_scaling);
}

std::shared_ptr<model::Model> model_of(const std::string& text, const std::string& name) {
  return std::make_shared<model::Model>(run::load_case_text(text, name).model);
}

py::str case_file_text(const std::string& path) {
  const std::string bytes = model::case_file_text(path);
  PyObject* text = PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "strict");
  if (text == nullptr) {
    PyErr_Clear();
    throw model::CaseFileError(path, 0, {}, "is not a text file in UTF-8");
  }
  return py::reinterpret_steal<py::str>(text);
}

/// The name of the parameter that was probably meant by an unknown key; empty if none is near.
std::string nearest_key(const std::string& key) {
  std::vector<std::string_view> keys;
  for (const model::Parameter& parameter : model::parameters()) keys.emplace_back(parameter.key);
  return std::string(base::nearest_word(key, keys));
}

}  // namespace

void bind_case(py::module_& module) {
  using Released = py::call_guard<py::gil_scoped_release>;
  module.def("case_template", &model::case_template);
  module.def("case_file_text", &case_file_text);
  module.def("nearest_key", &nearest_key);
  module.def("value_in", &value_in);
  module.def("given_keys", &given_keys);
  module.def("with_value", &with_value, Released());
  module.def("mistakes_in", &mistakes_in);
  module.def("check_json", &check_json, Released());
  module.def("model_of", &model_of, Released());
  module.def(
      "write_file",
      [](const std::string& path, const std::string& content) { results::write_file_atomically(path, content); },
      Released());
}

}  // namespace knitmech::python
