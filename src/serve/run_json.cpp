#include "serve/run_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "base/number_text.h"
#include "results/history_file.h"

namespace knitmech::serve {
namespace {

/// Numbers that are not finite become null when the document is written.
using Json = nlohmann::ordered_json;

template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string text_of(const Json& document) {
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json json_of(const RunHead& head) {
  return {{"id", head.id},
          {"title", head.title},
          {"status", head.status},
          {"active", head.active},
          {"can_go_on", head.can_go_on},
          {"strain", head.strain},
          {"target_strain", head.target_strain},
          {"rows", head.rows},
          {"frames", head.frames},
          {"live", head.live},
          {"seconds", head.seconds},
          {"seconds_left", or_null(head.seconds_left)},
          {"message", head.message},
          {"modified", head.modified}};
}

std::string crossings_sentence(const results::Quality& quality) {
  if (quality.lost_crossings > 0) return "A yarn went through another.";
  return fmt::format("All crossings were kept: no yarn went through another in {} checks.", quality.crossing_checks);
}

std::string sentence_of(const results::StoredRavelling& event) {
  return fmt::format("At {} strain {}.", base::percent_text(event.strain),
                     results::ravelled_text(event.place, "slipped "));
}

std::string place_text(const results::YarnPlace& place) {
  if (place.course == 0) return fmt::format("yarn {}, {:.3g} mm along the yarn", place.yarn + 1, place.arc_length);
  const std::string of_wale = place.wale ? fmt::format(", wale {}", *place.wale) : "";
  return fmt::format("course {}{} ({}), {:.3g} mm along the yarn", place.course, of_wale, place.part, place.arc_length);
}

std::string sentence_of(const results::StoredBreak& event) {
  return fmt::format("At {} strain a yarn broke in {}, with {} and stretched by {}.", base::percent_text(event.strain),
                     place_text(event.place), base::force_text(event.axial_force),
                     base::percent_text(event.axial_strain));
}

template <typename Event>
Json sentences(const std::vector<Event>& events) {
  Json list = Json::array();
  for (const Event& event : events) list.push_back(sentence_of(event));
  return list;
}

Json quality_of(const std::optional<results::RunSummary>& summary) {
  if (!summary || !summary->quality) return nullptr;
  const results::Quality& quality = *summary->quality;
  return {{"quasi_static", quality.quasi_static},
          {"verdict", quality.verdict},
          {"crossings", crossings_sentence(quality)},
          {"ravelling", sentences(summary->ravelled)},
          {"breaks", sentences(summary->breaks)},
          {"kinetic_ratio", or_null(quality.kinetic_ratio)},
          {"energy_balance", or_null(quality.energy_balance)},
          {"grip_difference", or_null(quality.grip_difference)},
          {"penetration", quality.penetration},
          {"penetration_ratio", quality.penetration_ratio}};
}

Json frame_list(const std::vector<results::FrameEntry>& frames) {
  Json list = Json::array();
  for (const results::FrameEntry& frame : frames) list.push_back({{"index", frame.index}, {"strain", frame.strain}});
  return list;
}

Json stage_list(const std::vector<results::CurveStage>& stages) {
  Json list = Json::array();
  for (const results::CurveStage& stage : stages) {
    list.push_back({{"name", stage.name}, {"from", stage.from}, {"to", stage.to}, {"slope", or_null(stage.slope)}});
  }
  return list;
}

}  // namespace

std::string head_json(const RunHead& head) {
  return text_of(json_of(head));
}

std::string list_json(const std::vector<RunHead>& heads) {
  Json list = Json::array();
  for (const RunHead& head : heads) list.push_back(json_of(head));
  return text_of(list);
}

std::string detail_json(const RunDetail& detail) {
  Json document = json_of(detail.head);
  document["case_text"] = detail.case_text;
  document["frame_list"] = frame_list(detail.frames);
  document["width"] = detail.width;
  document["gauge_length"] = detail.gauge_length;
  document["nodes"] = detail.nodes;
  document["elements"] = detail.elements;
  document["quality"] = quality_of(detail.summary);
  document["stages"] = stage_list(detail.stages);
  document["report"] = detail.report;
  document["mass_scaling"] = or_null(detail.mass_scaling);
  document["threads"] = or_null(detail.threads);
  return text_of(document);
}

std::string history_json(const std::vector<model::HistoryRow>& rows, std::size_t from) {
  std::vector<std::vector<double>> columns(results::kHistoryColumns);
  for (const model::HistoryRow& row : rows) {
    const auto values = results::history_values(row);
    for (std::size_t i = 0; i < values.size(); ++i) columns[i].push_back(values[i]);
  }
  Json by_name = Json::object();
  std::string_view names = results::kHistoryHeader;
  for (std::vector<double>& column : columns) {
    const std::string_view name = names.substr(0, names.find(','));
    by_name[std::string(name)] = std::move(column);
    names.remove_prefix(std::min(names.size(), name.size() + 1));
  }
  return text_of({{"from", from}, {"columns", std::move(by_name)}});
}

}  // namespace knitmech::serve
