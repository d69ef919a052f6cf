#include "study/read_measured.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace knitmech::study {
namespace {

namespace fs = std::filesystem;

void check_name(const StudyEntries& entries, const model::TomlEntry& entry) {
  static const std::vector<std::string_view> kNames = {"files",   "gauge_length",     "width", "load_column",
                                                       "samples", "extension_column", "offset"};
  constexpr std::string_view kSection = "measured.";
  if (!entry.key.starts_with(kSection)) return;
  const std::string name = entry.key.substr(kSection.size());
  if (std::ranges::find(kNames, std::string_view(name)) == kNames.end()) {
    entries.refuse(entry.line, entry.key,
                   fmt::format("there is no such key; the keys of [measured] are {}", base::alternatives(kNames)));
  }
}

void take_offset(const StudyEntries& entries, Measured& measured) {
  const model::TomlEntry* entry = entries.find("measured.offset");
  if (entry == nullptr) return;
  const auto* word = std::get_if<std::string>(&entry->value);
  const auto* number = std::get_if<double>(&entry->value);
  measured.finds_offset = word != nullptr && *word == "auto";
  if (measured.finds_offset) return;
  if (number == nullptr || !std::isfinite(*number)) {
    entries.refuse(entry->line, entry->key, "must be a strain such as 0.02, or \"auto\"");
  }
  measured.offset = *number;
}

}  // namespace

std::optional<Measured> read_measured(const StudyEntries& entries) {
  if (entries.find("measured") == nullptr) return std::nullopt;
  for (const model::TomlEntry& entry : entries.all()) check_name(entries, entry);
  Measured measured;
  for (const std::string& name : entries.texts_at("measured.files")) {
    const fs::path file = entries.path().parent_path() / name;
    if (!fs::is_regular_file(file)) {
      entries.refuse(entries.find("measured.files")->line, "measured.files",
                     fmt::format("there is no file {}", base::in_quotes(file.string())));
    }
    measured.files.push_back(file.string());
  }
  if (measured.files.empty()) {
    entries.refuse(entries.find("measured")->line, "measured.files",
                   "is missing; write for example files = [\"measured.csv\"]");
  }
  measured.gauge_length = entries.length_at("measured.gauge_length");
  measured.width = entries.length_at("measured.width");
  measured.load_column = entries.text_at("measured.load_column", "");
  measured.extension_column = entries.text_at("measured.extension_column", "");
  measured.samples = entries.texts_at("measured.samples");
  take_offset(entries, measured);
  return measured;
}

}  // namespace knitmech::study
