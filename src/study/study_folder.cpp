#include "study/study_folder.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "base/errors.h"
#include "model/case_file.h"
#include "results/atomic_file.h"
#include "study/measures.h"

namespace knitmech::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kStudyFile = "study.json";
constexpr const char* kTableFile = "table.csv";
constexpr const char* kBaseFile = "base.toml";
constexpr const char* kFormat = "knitmech-study";
constexpr int kSchema = 1;

bool is_study(const fs::path& file) {
  if (!fs::is_regular_file(file)) return false;
  const Json document = Json::parse(results::read_file(file), nullptr, /*allow_exceptions=*/false);
  return document.is_object() && document.value("format", Json{}) == kFormat;
}

void refuse_foreign_folder(const fs::path& folder) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) {
    throw InputError(fmt::format("\"{}\" is a file; give a folder for the study.", folder.string()));
  }
  if (!fs::is_empty(folder) && !is_study(folder / kStudyFile)) {
    throw InputError(
        fmt::format("\"{}\" holds files that are not a KnitMech study; give a new or empty folder.", folder.string()));
  }
}

/// A field of a CSV line: in quotes if it needs them.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char each : text) field += each == '"' ? std::string("\"\"") : std::string(1, each);
  return field + "\"";
}

std::string table_head(const Study& study, const std::vector<Measure>& measures) {
  std::string line = "run,standing";
  for (const Variation& variation : study.variations) line += "," + csv_field(variation.parameter->key);
  for (const Measure& measure : measures) line += "," + measure.name;
  return line + ",reason\n";
}

std::string table_line(const Study& study, const VariantState& state, const std::vector<Measure>& measures) {
  std::string line = fmt::format("{},{}", state.variant.name, name_of(state.standing));
  for (std::size_t i = 0; i < study.variations.size(); ++i) {
    line += "," + csv_field(value_text(*study.variations[i].parameter, state.variant.values[i]));
  }
  for (const Measure& measure : measures) line += measure.value ? fmt::format(",{}", *measure.value) : ",";
  return line + "," + csv_field(state.reason) + "\n";
}

Json run_json(const Study& study, const VariantState& state, const std::vector<Measure>& measures) {
  Json values = Json::object(), numbers = Json::object();
  for (std::size_t i = 0; i < study.variations.size(); ++i) {
    values[study.variations[i].parameter->key] = value_text(*study.variations[i].parameter, state.variant.values[i]);
  }
  for (const Measure& measure : measures) numbers[measure.name] = measure.value ? Json(*measure.value) : Json(nullptr);
  return {{"run", state.variant.name},
          {"standing", name_of(state.standing)},
          {"reason", state.reason},
          {"values", values},
          {"measures", numbers}};
}

Json head_json(const Study& study) {
  return {{"format", kFormat}, {"schema", kSchema}, {"program_version", KNITMECH_VERSION}, {"title", study.title}};
}

std::string json_text(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

void prepare_folder(const fs::path& folder, const Study& study) {
  try {
    refuse_foreign_folder(folder);
    fs::create_directories(folder / kRunsFolder);
  } catch (const fs::filesystem_error& error) {
    throw FileError(fmt::format("cannot write the folder {}: {}", folder.string(), error.code().message()));
  }
  // The mark of a study goes first, so that one that is killed at once can go on.
  if (!is_study(folder / kStudyFile)) {
    results::write_file_atomically(folder / kStudyFile, json_text(head_json(study)));
  }
  if (const auto& yarns = study.base.fabric.yarn_file) {
    results::write_file_atomically(folder / curves::plain_name(yarns->ending), yarns->bytes);
  }
  results::write_file_atomically(folder / kBaseFile, model::write_case(study.base));
}

void write_tables(const fs::path& folder, const Study& study, const std::vector<VariantState>& states) {
  const std::vector<Measure> none = measures_of({}, study.strains);
  std::string table = table_head(study, none);
  Json document = head_json(study);
  document["runs"] = Json::array();
  for (const VariantState& state : states) {
    const std::vector<Measure>& measures = state.measures.empty() ? none : state.measures;
    table += table_line(study, state, measures);
    document["runs"].push_back(run_json(study, state, measures));
  }
  results::write_file_atomically(folder / kTableFile, table);
  results::write_file_atomically(folder / kStudyFile, json_text(document));
}

}  // namespace knitmech::study
