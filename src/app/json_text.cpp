#include "app/json_text.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "model/case_file.h"

namespace knitmech::app {
namespace {

using Json = nlohmann::ordered_json;

/// Text of a user need not be UTF-8; what is not is replaced.
std::string text_of(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
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
