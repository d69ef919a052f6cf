#include "results/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/errors.h"
#include "model/bending_measure.h"
#include "results/atomic_file.h"
#include "results/curve_measures.h"
#include "results/curve_stages.h"
#include "results/ravelling.h"
#include "results/yarn_place.h"

namespace knitmech::results {
namespace {

using Json = nlohmann::ordered_json;
using model::HistoryRow;
using model::Model;
using model::RunOutcome;
using model::RunStatus;

/// Doubles that are not finite become null when the document is written (nlohmann-json's rule for JSON without NaN).
Json number(std::optional<double> value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string text_of(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

const char* status_name(RunStatus status) {
  switch (status) {
    case RunStatus::completed:
      return "completed";
    case RunStatus::interrupted:
      return "interrupted";
    case RunStatus::failed:
      return "failed";
  }
  return "unknown";
}

Json head(const Model& model, const char* status) {
  return {{"format", kSummaryFormat},
          {"schema", kSummarySchema},
          {"program_version", KNITMECH_VERSION},
          {"title", model.title},
          {"status", status}};
}

Json model_block(const Model& model) {
  return {{"yarns", model.yarns.size()},
          {"nodes", model.n_nodes()},
          {"elements", model.n_elements()},
          {"degrees_of_freedom", 6 * static_cast<long>(model.n_nodes())},
          {"gauge_length_mm", number(model.test.gauge_length)},
          {"friction", number(model.friction)},
          {"contact_stiffness_N_per_mm", number(model.contact_stiffness)}};
}

Json solver_block(const Model& model, const RunOutcome& outcome) {
  const double element_steps = static_cast<double>(model.n_elements()) * static_cast<double>(outcome.steps);
  return {
      {"mass_scaling", number(outcome.mass_scaling)},
      {"threads", outcome.threads},
      {"steps", outcome.steps},
      {"smallest_step_s", number(outcome.smallest_step)},
      {"simulated_time_s", number(outcome.time)},
      {"wall_s", number(outcome.wall_seconds)},
      {"element_steps_per_s", outcome.wall_seconds > 0 ? number(element_steps / outcome.wall_seconds) : Json(nullptr)}};
}

Json final_block(const std::vector<HistoryRow>& history, const RunOutcome& outcome) {
  Json block{{"strain", number(outcome.strain)}};
  const std::optional<HistoryRow> row = history.empty() ? std::nullopt : std::optional{history.back()};
  const auto add = [&](const char* key, double HistoryRow::*member) {
    block[key] = row ? number((*row).*member) : Json(nullptr);
  };
  add("displacement_mm", &HistoryRow::displacement);
  add("force_top_N", &HistoryRow::force_top);
  add("force_bottom_N", &HistoryRow::force_bottom);
  add("external_work_mJ", &HistoryRow::external_work);
  add("internal_energy_mJ", &HistoryRow::internal_energy);
  add("stretch_energy_mJ", &HistoryRow::stretch_energy);
  add("friction_loss_mJ", &HistoryRow::friction_loss);
  add("damping_loss_mJ", &HistoryRow::damping_loss);
  add("break_loss_mJ", &HistoryRow::break_loss);
  add("width_mm", &HistoryRow::width);
  return block;
}

Json contact_block(const std::optional<ContactSummary>& contacts) {
  const auto value = [&](double ContactSummary::*member) {
    return contacts ? number((*contacts).*member) : Json(nullptr);
  };
  return {{"contacts", contacts ? Json(contacts->contacts) : Json(nullptr)},
          {"normal_force_N", value(&ContactSummary::normal_force)},
          {"slipping_share", number(contacts ? contacts->slipping_share : std::nullopt)},
          {"elastic_slip_mm", value(&ContactSummary::elastic_slip)},
          {"elastic_slip_ratio", value(&ContactSummary::elastic_slip_ratio)}};
}

Json largest_block(const Model& model, const std::vector<HistoryRow>& history, const RunOutcome& outcome) {
  const auto largest = [&](auto member) -> Json {
    if (history.empty()) {
      return nullptr;
    }
    const auto row = std::max_element(history.begin(), history.end(),
                                      [&](const HistoryRow& a, const HistoryRow& b) { return a.*member < b.*member; });
    return (*row).*member;
  };
  std::optional<double> tie_stretch, tie_stretch_ratio;
  if (!model.ties.empty()) {
    tie_stretch = outcome.largest_tie_stretch;
    tie_stretch_ratio = outcome.largest_tie_stretch / model.sections.front().diameter;
  }
  return {{"force_top_N", largest(&HistoryRow::force_top)},
          {"force_bottom_N", largest(&HistoryRow::force_bottom)},
          {"kinetic_energy_mJ", largest(&HistoryRow::kinetic_energy)},
          {"contacts", largest(&HistoryRow::contacts)},
          {"contact_normal_force_N", largest(&HistoryRow::normal_force)},
          {"penetration_mm", number(outcome.largest_penetration)},
          {"tie_stretch_mm", number(tie_stretch)},
          {"tie_stretch_ratio", number(tie_stretch_ratio)}};
}

Json place_json(const YarnPlace& place) {
  return {{"yarn", place.yarn},
          {"course", place.course > 0 ? Json(place.course) : Json(nullptr)},
          {"wale", place.wale ? Json(*place.wale) : Json(nullptr)},
          {"part", place.part},
          {"place_mm", number(place.arc_length)}};
}

Json peaks_block(const Model& model, const SectionPeaks& peaks) {
  Json block;
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    const std::optional<SectionPeak>& peak = peaks[k];
    block[kPeakFields[k].key] = nullptr;
    if (!peak) continue;
    Json entry{{"value", number(peak->value)}, {"frame", peak->frame}, {"strain", number(peak->strain)}};
    entry.update(place_json(place_of_element(model, peak->element)));
    block[kPeakFields[k].key] = entry;
  }
  return block;
}

Json quality_block(const Quality& quality) {
  return {{"quasi_static", quality.quasi_static},
          {"verdict", quality.verdict},
          {"toe_strain", number(quality.toe_strain)},
          {"kinetic_ratio", number(quality.kinetic_ratio)},
          {"kinetic_ratio_strain", number(quality.kinetic_ratio_strain)},
          {"energy_balance_end", number(quality.energy_balance_end)},
          {"energy_balance", number(quality.energy_balance)},
          {"energy_balance_strain", number(quality.energy_balance_strain)},
          {"grip_difference", number(quality.grip_difference)},
          {"grip_difference_strain", number(quality.grip_difference_strain)},
          {"penetration_mm", number(quality.penetration)},
          {"penetration_ratio", number(quality.penetration_ratio)},
          {"elastic_slip_mm", number(quality.elastic_slip)},
          {"elastic_slip_ratio", number(quality.elastic_slip_ratio)},
          {"lost_crossings", quality.lost_crossings},
          {"crossings_kept", quality.lost_crossings == 0},
          {"crossing_checks", quality.crossing_checks}};
}

Json stages_block(const CurveStages& stages) {
  Json block = Json::array();
  for (const CurveStage& stage : stages.stages) {
    block.push_back({{"name", stage.name},
                     {"from_strain", number(stage.from)},
                     {"to_strain", number(stage.to)},
                     {"slope_N", number(stage.slope)},
                     {"slope_N_per_mm", number(stage.slope_per_width)}});
  }
  return block;
}

Json measures_block(const CurveStages& stages, const std::vector<HistoryRow>& history,
                    const std::vector<FrameMeasures>& frames) {
  Json list = Json::array();
  for (const FrameMeasures& frame : frames) {
    const auto measure = measure_at(history, frame.strain);
    if (!measure) continue;
    list.push_back({{"strain", number(measure->strain)},
                    {"force_N", number(measure->force)},
                    {"force_N_per_mm", number(measure->force_per_width)},
                    {"secant_N_per_mm", number(measure->secant)},
                    {"tangent_N_per_mm", number(measure->tangent)},
                    {"width_mm", number(measure->width)},
                    {"contraction", number(measure->contraction)},
                    {"poissons_ratio", number(measure->poissons_ratio)}});
  }
  return {{"bending_strain", number(stages.bending_strain)},
          {"stretch_strain", number(stages.stretch_strain)},
          {"stretch_share_at_end", number(stages.stretch_share)},
          {"at", list}};
}

Json frames_block(const std::vector<FrameMeasures>& frames) {
  Json block = Json::array();
  for (const FrameMeasures& frame : frames) {
    block.push_back({{"frame", frame.index},
                     {"strain", number(frame.strain)},
                     {"lowest_z_mm", number(frame.lowest_z)},
                     {"highest_z_mm", number(frame.highest_z)},
                     {"contacts", frame.contacts},
                     {"contacts_in_middle_third", number(frame.contacts_in_middle)},
                     {"contact_force_in_middle_third", number(frame.force_in_middle)}});
  }
  return block;
}

Json breaks_block(const Model& model, const RunOutcome& outcome) {
  Json block = Json::array();
  for (const model::YarnBreak& event : outcome.breaks) {
    Json entry{{"strain", number(event.strain)},
               {"axial_force_N", number(event.axial_force)},
               {"axial_strain", number(event.axial_strain)}};
    entry.update(place_json(place_of_element(model, static_cast<std::size_t>(event.element))));
    entry["position_mm"] = {event.position.x(), event.position.y(), event.position.z()};
    block.push_back(entry);
  }
  return block;
}

Json ravelled_block(const Model& model, const RunOutcome& outcome) {
  Json block = Json::array();
  for (const model::Ravelling& event : outcome.ravelled) {
    const RavelledPlace place = place_of(model, event);
    const auto of_stitches = [&](int number) { return model.has_stitches ? Json(number) : Json(nullptr); };
    block.push_back({{"strain", number(event.strain)},
                     {"yarn", event.yarn},
                     {"course", of_stitches(place.course)},
                     {"end", place.side},
                     {"over_yarn", event.other_yarn},
                     {"over_course", of_stitches(place.other_course)},
                     {"over_wale", of_stitches(place.other_wale)},
                     {"position_mm", {event.position.x(), event.position.y(), event.position.z()}}});
  }
  return block;
}

/// The text of a key at the top of a summary; empty if there is none.
std::string text_in_summary(const std::filesystem::path& path, const char* key) {
  const Json document = Json::parse(read_file(path), nullptr, /*allow_exceptions=*/false);
  const Json value = document.is_object() ? document.value(key, Json{}) : Json{};
  return value.is_string() ? value.get<std::string>() : "";
}

}  // namespace

std::string running_summary(const Model& model) {
  Json document = head(model, "running");
  document["model"] = model_block(model);
  return text_of(document);
}

std::string finished_summary(const Model& model, const std::vector<HistoryRow>& history,
                             const std::vector<FrameMeasures>& frames, const std::optional<ContactSummary>& contacts,
                             const SectionPeaks& peaks, const RunOutcome& outcome, const Quality& quality) {
  Json document = head(model, status_name(outcome.status));
  document["reason"] = outcome.reason;
  document["advice"] = outcome.advice;
  document["model"] = model_block(model);
  document["output"] = {{"history_rows", history.size()}, {"frames", frames.size()}};
  document["solver"] = solver_block(model, outcome);
  document["final"] = final_block(history, outcome);
  document["contact"] = contact_block(contacts);
  document["largest"] = largest_block(model, history, outcome);
  document["frames"] = frames_block(frames);
  document["largest_in_yarns"] = peaks_block(model, peaks);
  document["quality"] = quality_block(quality);
  const CurveStages stages = history.empty() ? CurveStages{} : curve_stages(history, model::bending_measure(model));
  document["stages"] = stages_block(stages);
  document["measures"] = measures_block(stages, history, frames);
  document["ravelled"] = ravelled_block(model, outcome);
  document["breaks"] = breaks_block(model, outcome);
  return text_of(document);
}

bool is_summary(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) {
    return false;
  }
  const Json document = Json::parse(read_file(path), nullptr, /*allow_exceptions=*/false);
  return document.is_object() && document.value("format", Json{}) == kSummaryFormat;
}

SummaryFacts facts_in_summary(const std::filesystem::path& path) {
  const Json document = Json::parse(read_file(path), nullptr, /*allow_exceptions=*/false);
  try {
    return {.title = document.at("title").get<std::string>(),
            .status = document.at("status").get<std::string>(),
            .gauge_length = document.at("model").at("gauge_length_mm").get<double>()};
  } catch (const Json::exception&) {
    throw InputError(fmt::format("{}: has no title, status and gauge length; it must be as `knitmech run` has left it",
                                 path.string()));
  }
}

std::string status_in_summary(const std::filesystem::path& path) {
  return text_in_summary(path, "status");
}

std::string reason_in_summary(const std::filesystem::path& path) {
  return text_in_summary(path, "reason");
}

}  // namespace knitmech::results
