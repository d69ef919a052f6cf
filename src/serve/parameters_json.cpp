#include "serve/parameters_json.h"

#include <nlohmann/json.hpp>

#include "base/quantity.h"
#include "model/edit_case.h"
#include "model/parameters.h"

namespace knitmech::serve {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(model::Kind kind) {
  switch (kind) {
    case model::Kind::text:
      return "text";
    case model::Kind::quantity:
      return "quantity";
    case model::Kind::whole_number:
      return "whole number";
    case model::Kind::list_of_quantities:
      return "list of quantities";
    case model::Kind::choice:
      return "choice";
  }
  return "";
}

const char* name_of(model::Need need) {
  switch (need) {
    case model::Need::required:
      return "required";
    case model::Need::defaulted:
      return "defaulted";
    case model::Need::automatic:
      return "automatic";
    case model::Need::optional:
      return "optional";
  }
  return "";
}

bool has_range(const model::Parameter& parameter) {
  const model::Kind kind = model::kind_of(parameter);
  return kind != model::Kind::text && kind != model::Kind::choice;
}

Json range_end(const model::Parameter& parameter, double value) {
  if (!has_range(parameter)) return nullptr;
  const auto units = base::units_of(parameter.dimension);
  return units.empty() ? value : value * units.front().divide / units.front().multiply;
}

Json parameter_json(const model::Parameter& parameter) {
  const auto units = base::units_of(parameter.dimension);
  return {{"key", parameter.key},
          {"section", model::section_name_of(parameter.key)},
          {"name", model::name_of(parameter.key)},
          {"symbol", parameter.symbol},
          {"kind", name_of(model::kind_of(parameter))},
          {"unit", units.empty() ? "" : units.front().name},
          {"need", name_of(parameter.need)},
          {"value", model::typed_text(parameter, parameter.value)},
          {"least", range_end(parameter, parameter.range.least)},
          {"greatest", range_end(parameter, parameter.range.greatest)},
          {"least_excluded", parameter.range.least_excluded},
          {"choices", parameter.choices},
          {"help", parameter.help}};
}

}  // namespace

std::string parameters_json() {
  Json sections = Json::array();
  for (const model::CaseSection& section : model::sections()) {
    sections.push_back({{"name", section.name}, {"help", section.help}});
  }
  Json parameters = Json::array();
  for (const model::Parameter& parameter : model::parameters()) {
    // The page sends the text of a case without a folder, in which a file of yarns could stand.
    if (parameter.from != model::FabricFrom::file) parameters.push_back(parameter_json(parameter));
  }
  return Json{{"sections", sections}, {"parameters", parameters}}.dump();
}

}  // namespace knitmech::serve
