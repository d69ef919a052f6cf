#include "run/load_case.h"

#include "model/build_model.h"
#include "model/case_file.h"
#include "model/parameters.h"

namespace knitmech::run {
namespace {

/// The key that a message names first; empty if it names none.
std::string first_key_in(std::string_view message) {
  std::string_view key;
  auto first = std::string_view::npos;
  for (const model::Parameter& parameter : model::parameters()) {
    const auto place = message.find(parameter.key);
    const bool earlier = place != std::string_view::npos && (first == std::string_view::npos || place < first);
    if (!earlier || model::section_name_of(parameter.key).empty()) continue;
    first = place;
    key = parameter.key;
  }
  return std::string(key);
}

}  // namespace

LoadedCase load_case(const std::filesystem::path& path) {
  return load_case_text(model::case_file_text(path), path.string(), path.parent_path());
}

LoadedCase load_case_text(std::string_view text, const std::string& name,
                          const std::optional<std::filesystem::path>& folder) {
  LoadedCase loaded{.input = model::parse_case(text, name, folder), .model = {}};
  try {
    loaded.model = model::build_model(loaded.input);
  } catch (const InputError& error) {
    const std::string key = first_key_in(error.what());
    throw model::CaseFileError(name, key.empty() ? 0 : model::line_of_key(text, key), key, error.what());
  }
  return loaded;
}

}  // namespace knitmech::run
