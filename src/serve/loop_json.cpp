#include "serve/loop_json.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>

#include "base/errors.h"
#include "knit/erc.h"
#include "model/build_model.h"
#include "model/case_file.h"
#include "model/parameter_value.h"
#include "model/parameters.h"
#include "model/toml_entries.h"

namespace knitmech::serve {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPathPieces = 120;
constexpr double kDegrees = 180 / std::numbers::pi;

/// What a text gives for the parameters of the loop, each for itself.
struct LoopValues {
  model::Case input = model::default_case();
  int n_shape_values = 0;  ///< of the six that a loop needs
  bool has_diameter = false, has_spacing = false;
};

constexpr std::array kShapeKeys{"loop.height",      "loop.width",     "loop.head_flat",
                                "loop.head_radius", "loop.foot_flat", "loop.foot_radius"};

void take(LoopValues& values, const model::TomlEntry& entry) {
  const model::Parameter* parameter = model::find_parameter(entry.key);
  if (parameter == nullptr || std::holds_alternative<model::TomlSection>(entry.value)) return;
  try {
    model::set_value(values.input, *parameter, model::value_from(*parameter, entry.value));
  } catch (const InputError&) {
    return;  // told as a mistake of the case
  }
  for (const char* key : kShapeKeys) values.n_shape_values += entry.key == key ? 1 : 0;
  values.has_diameter = values.has_diameter || entry.key == "yarn.diameter";
  values.has_spacing = values.has_spacing || entry.key == "fabric.course_spacing";
}

std::optional<LoopValues> values_of(std::string_view case_text) {
  LoopValues values;
  try {
    for (const model::TomlEntry& entry : model::toml_entries(case_text)) take(values, entry);
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (values.n_shape_values < static_cast<int>(kShapeKeys.size()) || !values.has_diameter) return std::nullopt;
  return values;
}

/// The shape with the depth that the case gives or the program finds; flat where it finds none.
knit::LoopShape shape_of(const model::Case& input) {
  const model::Case::Loop& loop = input.loop;
  knit::LoopShape shape{loop.height, loop.width, loop.head_flat, loop.head_radius, loop.foot_flat, loop.foot_radius, 0};
  try {
    shape.out_of_plane = model::resolved_layout(input).loop.out_of_plane;
  } catch (const InputError&) {
    shape.out_of_plane = loop.out_of_plane.value_or(0);
  }
  return shape;
}

Json drawing_of(const knit::Erc& erc, const LoopValues& values) {
  Json points;
  for (std::size_t i = 0; i < erc.control_points.size(); ++i) {
    points[fmt::format("P{}", i + 1)] = {erc.control_points[i].x(), erc.control_points[i].y()};
  }
  Json path = Json::array();
  for (const knit::CurvePoint& point : knit::equal_arc_points(erc, kPathPieces)) {
    path.push_back({point.position.x(), point.position.y(), point.position.z()});
  }
  const knit::LoopShape& shape = erc.shape;
  return {{"points", points},
          {"path", path},
          {"height", shape.height},
          {"width", shape.width},
          {"head_flat", shape.head_flat},
          {"head_radius", shape.head_radius},
          {"foot_flat", shape.foot_flat},
          {"foot_radius", shape.foot_radius},
          {"diameter", values.input.yarn.diameter},
          {"course_spacing", values.has_spacing ? Json(values.input.fabric.course_spacing) : Json(nullptr)},
          {"theta1_degrees", erc.theta1 * kDegrees},
          {"theta2_degrees", erc.theta2 * kDegrees},
          {"erc_length", erc.length}};
}

}  // namespace

Json loop_json(std::string_view case_text) {
  const auto values = values_of(case_text);
  if (!values) return nullptr;
  try {
    return drawing_of(knit::make_erc(shape_of(values->input)), *values);
  } catch (const InputError&) {
    return nullptr;
  }
}

}  // namespace knitmech::serve
