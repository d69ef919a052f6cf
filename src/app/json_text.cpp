#include "app/json_text.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "app/structure_texts.h"
#include "model/case_file.h"
#include "run/run_estimate.h"
#include "solve/mass_scaling.h"

namespace knitmech::app {
namespace {

using Json = nlohmann::ordered_json;

/// Text of a user need not be UTF-8; what is not is replaced.
std::string text_of(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

Json gap_json(const std::optional<knit::Approach>& approach) {
  if (!approach) return nullptr;
  return {{"gap_mm", approach->gap}, {"between", {describe(approach->a), describe(approach->b)}}};
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json filaments_json(const model::YarnStiffness& yarn) {
  if (!yarn.filaments) return nullptr;
  return {{"number", *yarn.filaments}, {"diameter_mm", *yarn.filament_diameter}, {"turns_per_mm", *yarn.twist}};
}

Json edge_yarn_json(const model::Case& input, const model::FabricFacts& facts) {
  if (!facts.edge_section) return nullptr;
  return {{"diameter_mm", facts.edge_section->diameter},
          {"axial_stiffness_N", facts.edge_section->axial_stiffness},
          {"bending_stiffness_N_mm2", facts.edge_section->bending_stiffness},
          {"torsional_stiffness_N_mm2", facts.edge_section->torsional_stiffness},
          {"filaments", filaments_json(input.edge_yarn)},
          {"friction", edge_friction(input)}};
}

Json structure_json(const run::LoadedCase& loaded, const model::FabricFacts& facts) {
  return {{"name", structure_name(loaded.input.fabric.structure)},
          {"yarns", loaded.model.yarns.size()},
          {"ties", facts.n_ties},
          {"turning_arcs", facts.n_turning_arcs},
          {"turning_arc_length_mm", facts.edge_section ? Json(facts.turning_arc_length) : Json(nullptr)}};
}

Json specimens_json(const YarnAnalysis& analysis) {
  Json list = Json::array();
  for (std::size_t i = 0; i < analysis.curves.size(); ++i) {
    const yarn::Break end = yarn::break_of(analysis.curves[i]);
    list.push_back({{"name", analysis.curves[i].name},
                    {"strength_N", end.force},
                    {"breaking_strain", end.strain},
                    {"axial_stiffness_N", analysis.slopes[i]}});
  }
  return list;
}

}  // namespace

std::string error_json(const std::runtime_error& error, ExitCode code) {
  Json block{{"message", error.what()}, {"exit_code", code}};
  if (const auto* mistake = dynamic_cast<const model::CaseFileError*>(&error)) {
    block["file"] = mistake->file();
    block["line"] = mistake->line() > 0 ? Json(mistake->line()) : Json(nullptr);
    block["key"] = mistake->key().empty() ? Json(nullptr) : Json(mistake->key());
  }
  return text_of({{"error", block}});
}

std::string check_json(const run::LoadedCase& loaded, const model::FabricFacts& facts, double mass_scaling) {
  const model::Model& model = loaded.model;
  return text_of(
      {{"title", model.title},
       {"structure", structure_json(loaded, facts)},
       {"elements", facts.n_elements},
       {"nodes", facts.n_nodes},
       {"degrees_of_freedom", facts.n_degrees_of_freedom},
       {"loop_length_mm", facts.stitch_length},
       {"yarn_length_mm", facts.yarn_length},
       {"leg_angle_head_rad", facts.erc.theta1},
       {"leg_angle_foot_rad", facts.erc.theta2},
       {"out_of_plane_per_mm", facts.out_of_plane},
       {"least_out_of_plane_per_mm", facts.least_out_of_plane},
       {"least_gap_on_curve", gap_json(facts.closest_on_curve)},
       {"least_gap_on_elements", gap_json(facts.closest_on_elements)},
       {"width_mm", facts.width},
       {"height_mm", facts.height},
       {"thickness_mm", facts.thickness},
       {"mass_per_area_g_per_m2", facts.mass_per_area},
       {"axial_stiffness_N", facts.section.axial_stiffness},
       {"bending_stiffness_N_mm2", facts.section.bending_stiffness},
       {"torsional_stiffness_N_mm2", facts.section.torsional_stiffness},
       {"filaments", filaments_json(loaded.input.yarn)},
       {"edge_yarn", edge_yarn_json(loaded.input, facts)},
       {"friction", model.friction},
       {"contact_stiffness_N_per_mm", model.contact_stiffness},
       {"gauge_length_mm", model.test.gauge_length},
       {"strain", model.test.strain},
       {"duration_s",
        solve::adapts_pace(loaded.input, mass_scaling) ? Json(nullptr) : Json(model.test.time_at(model.test.strain))},
       {"mass_scaling", mass_scaling},
       {"estimated_seconds", run::estimate_run(loaded).seconds}});
}

std::string files_json(const std::vector<std::filesystem::path>& files) {
  Json names = Json::array();
  for (const std::filesystem::path& file : files) names.push_back(file.string());
  return text_of({{"files", names}});
}

std::string run_json(const std::string& summary, const std::filesystem::path& folder) {
  Json document = Json::parse(summary);
  document["folder"] = folder.string();
  return text_of(document);
}

std::string yarn_json(const YarnAnalysis& analysis, const std::string& block, const std::filesystem::path& folder) {
  const yarn::LineFit& fit = analysis.fit;
  return text_of({{"specimens", specimens_json(analysis)},
                  {"strength_N", analysis.mean_break.force},
                  {"breaking_strain", analysis.mean_break.strain},
                  {"axial_stiffness_N", fit.slope},
                  {"youngs_modulus_MPa", optional_json(analysis.youngs_modulus())},
                  {"fit",
                   {{"from_strain", fit.range.from},
                    {"to_strain", fit.range.to},
                    {"intercept_N", fit.intercept},
                    {"r_squared", fit.r_squared},
                    {"rms_over_largest_force", fit.rms_ratio}}},
                  {"axial_stiffness_at_zero_N",
                   analysis.law.empty() ? Json(nullptr) : Json(yarn::AxialLaw(analysis.law).slope_at_zero())},
                  {"diameter_mm", optional_json(analysis.fineness.diameter)},
                  {"warnings", analysis.warnings},
                  {"section", block.empty() ? Json(nullptr) : Json(block)},
                  {"folder", folder.string()}});
}

}  // namespace knitmech::app
