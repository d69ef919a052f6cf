#include "run/check_json.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "model/parameters.h"
#include "run/run_estimate.h"
#include "solve/mass_scaling.h"

namespace knitmech::run {
namespace {

using Json = nlohmann::ordered_json;

Json gap_json(const std::optional<knit::Approach>& approach) {
  if (!approach) return nullptr;
  return {{"gap_mm", approach->gap}, {"between", {describe(approach->a), describe(approach->b)}}};
}

Json file_json(const LoadedCase& loaded, const model::FabricFacts& facts) {
  const auto place = [](const curves::PlaceOnLine& on) {
    return Json{{"yarn", on.yarn + 1}, {"place_mm", on.arc_length}};
  };
  const model::FileFacts& file = *facts.file;
  Json gap = nullptr;
  if (file.closest) {
    gap = {{"gap_mm", file.closest->distance - loaded.input.yarn.diameter},
           {"between", {place(file.closest->a), place(file.closest->b)}}};
  }
  return {{"file", loaded.input.fabric.yarn_file->path.string()},
          {"yarns", loaded.model.yarns.size()},
          {"points", file.n_points},
          {"element_length_mm", file.element_length},
          {"half_stitch_mm", file.half_stitch},
          {"diameter_in_file_mm", file.diameter_in_file > 0 ? Json(file.diameter_in_file) : Json(nullptr)},
          {"grip_depth_mm", file.grip_depth},
          {"nodes_in_bottom_grip", file.n_bottom},
          {"nodes_in_top_grip", file.n_top},
          {"least_gap", gap}};
}

/// "basic", "tied" or "adjusted".
std::string structure_name(const model::Case& input) {
  return std::get<std::string>(model::value_in(input, *model::find_parameter("fabric.structure")));
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
          {"friction", input.contact.edge_friction.value_or(input.contact.friction)}};
}

Json structure_json(const LoadedCase& loaded, const model::FabricFacts& facts) {
  return {{"name", structure_name(loaded.input)},
          {"yarns", loaded.model.yarns.size()},
          {"ties", facts.n_ties},
          {"turning_arcs", facts.n_turning_arcs},
          {"turning_arc_length_mm", facts.edge_section ? Json(facts.turning_arc_length) : Json(nullptr)}};
}

}  // namespace

std::string check_json(const LoadedCase& loaded, const model::FabricFacts& facts, double mass_scaling) {
  const model::Model& model = loaded.model;
  const bool has_loops = !facts.file;
  const auto of_loops = [&](const auto& value) { return has_loops ? Json(value) : Json(nullptr); };
  const Json document{
      {"title", model.title},
      {"structure", has_loops ? structure_json(loaded, facts) : Json(nullptr)},
      {"from_file", has_loops ? Json(nullptr) : file_json(loaded, facts)},
      {"elements", facts.n_elements},
      {"nodes", facts.n_nodes},
      {"degrees_of_freedom", facts.n_degrees_of_freedom},
      {"loop_length_mm", facts.stitch_length},
      {"yarn_length_mm", facts.yarn_length},
      {"leg_angle_head_rad", of_loops(facts.erc.theta1)},
      {"leg_angle_foot_rad", of_loops(facts.erc.theta2)},
      {"out_of_plane_per_mm", of_loops(facts.out_of_plane)},
      {"least_out_of_plane_per_mm", of_loops(facts.least_out_of_plane)},
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
      {"estimated_seconds", estimate_run(loaded).seconds}};
  // A title need not be UTF-8; what is not is replaced.
  return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace knitmech::run
