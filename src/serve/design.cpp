#include "serve/design.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "model/case_file.h"
#include "model/edit_case.h"
#include "model/facts.h"
#include "model/parameters.h"
#include "run/load_case.h"
#include "run/run_estimate.h"
#include "serve/blob.h"
#include "serve/loop_json.h"
#include "serve/mistake_json.h"
#include "serve/model_arrays.h"
#include "solve/mass_scaling.h"

namespace knitmech::serve {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kName = "case";  // of the text, in messages that are not shown

Json given_json(std::string_view text) {
  Json given = Json::object();
  try {
    for (const model::TomlEntry& entry : model::toml_entries(text)) {
      if (std::holds_alternative<model::TomlSection>(entry.value)) continue;
      given[entry.key] = {{"typed", model::typed_text(entry.value)}, {"line", entry.line}};
    }
  } catch (const model::TomlSyntaxError&) {
    return Json::object();  // told as a mistake of the case
  }
  return given;
}

Json effective_json(const model::Case& input) {
  Json values;
  for (const model::Parameter& parameter : model::parameters()) {
    values[parameter.key] = model::typed_text(parameter, model::value_in(input, parameter));
  }
  return values;
}

Json gap_json(const std::optional<knit::Approach>& approach) {
  if (!approach) return nullptr;
  return {{"gap", approach->gap}, {"between", {describe(approach->a), describe(approach->b)}}};
}

Json facts_json(const run::LoadedCase& loaded) {
  const model::FabricFacts facts = model::describe(loaded.input, loaded.model);
  const double mass_scaling = loaded.input.solver.mass_scaling ? *loaded.input.solver.mass_scaling
                                                               : solve::automatic_mass_scaling(loaded.model);
  return {{"loop_length", facts.stitch_length},
          {"yarn_length", facts.yarn_length},
          {"elements", facts.n_elements},
          {"nodes", facts.n_nodes},
          {"yarns", loaded.model.yarns.size()},
          {"ties", facts.n_ties},
          {"turning_arcs", facts.n_turning_arcs},
          {"out_of_plane", facts.out_of_plane},
          {"out_of_plane_chosen", facts.automatic_out_of_plane},
          {"least_out_of_plane", facts.least_out_of_plane},
          {"least_gap", gap_json(facts.closest_on_curve)},
          {"least_gap_on_elements", gap_json(facts.closest_on_elements)},
          {"width", facts.width},
          {"height", facts.height},
          {"thickness", facts.thickness},
          {"mass_per_area", facts.mass_per_area},
          {"axial_stiffness", facts.section.axial_stiffness},
          {"bending_stiffness", facts.section.bending_stiffness},
          {"torsional_stiffness", facts.section.torsional_stiffness},
          {"contact_stiffness", loaded.model.contact_stiffness},
          {"mass_scaling", mass_scaling},
          {"estimated_seconds", run::estimate_run(loaded).seconds}};
}

/// The case of a text that reads, with the mistake of its geometry if there is one. Several values make a geometry: the
/// one that was edited last has the mistake if the sentence names it.
std::optional<run::LoadedCase> load(const std::string& text, const std::optional<DesignEdit>& edit, Json& mistakes) {
  try {
    return run::load_case_text(text, kName);
  } catch (const model::CaseFileError& error) {
    mistakes.push_back(mistake_json(error));
    if (edit && error.complaint().find(edit->key) != std::string::npos) {
      mistakes.back()["key"] = edit->key;
      mistakes.back()["line"] = model::line_of_key(text, edit->key);
    }
    return std::nullopt;
  }
}

}  // namespace

std::string design_blob(const DesignRequest& request) {
  const std::string text =
      request.edit ? model::with_value(request.text, request.edit->key, request.edit->typed) : request.text;
  Json head{{"text", text},
            {"given", given_json(text)},
            {"effective", Json::object()},
            {"mistakes", Json::array()},
            {"loop", loop_json(text)},
            {"facts", nullptr},
            {"fabric", nullptr}};
  Json& mistakes = head["mistakes"];
  for (const model::CaseFileError& mistake : model::mistakes_in(text, kName)) mistakes.push_back(mistake_json(mistake));

  Blob blob;
  const auto loaded = mistakes.empty() ? load(text, request.edit, mistakes) : std::nullopt;
  if (loaded) {
    head["effective"] = effective_json(loaded->input);
    head["facts"] = facts_json(*loaded);
    if (request.fabric && loaded->model.n_elements() <= kMostElementsDrawn) {
      head["fabric"] = fabric_json(loaded->model);
      add_model(blob, loaded->model);
    }
  }
  return blob.bytes(head.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace knitmech::serve
