#include "study/study_entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/quantity.h"
#include "model/case_file.h"

namespace knitmech::study {

namespace fs = std::filesystem;

StudyEntries::StudyEntries(std::string_view text, fs::path path) : path_(std::move(path)) {
  constexpr int kDepth = 2;  // a section is a parameter, [loop.height]
  try {
    entries_ = model::toml_entries(text, kDepth);
  } catch (const model::TomlSyntaxError& error) {
    refuse(error.line(), "", error.what());
  }
}

void StudyEntries::refuse(int line, const std::string& key, const std::string& complaint) const {
  throw model::CaseFileError(path_.string(), line, key, complaint);
}

const model::TomlEntry* StudyEntries::find(std::string_view key) const {
  const auto found = std::ranges::find(entries_, key, &model::TomlEntry::key);
  return found == entries_.end() ? nullptr : &*found;
}

std::string StudyEntries::text_at(std::string_view key, const std::string& otherwise) const {
  const model::TomlEntry* entry = find(key);
  if (entry == nullptr) return otherwise;
  const auto* text = std::get_if<std::string>(&entry->value);
  if (text == nullptr) refuse(entry->line, entry->key, "is no text; write it in quotes");
  return *text;
}

std::int64_t StudyEntries::whole_at(std::string_view key, std::int64_t otherwise, std::int64_t least,
                                    std::int64_t greatest) const {
  const model::TomlEntry* entry = find(key);
  if (entry == nullptr) return otherwise;
  const auto* whole = std::get_if<std::int64_t>(&entry->value);
  if (whole == nullptr || *whole < least || *whole > greatest) {
    refuse(entry->line, entry->key, fmt::format("must be a whole number from {} to {}", least, greatest));
  }
  return *whole;
}

std::vector<model::TomlItem> StudyEntries::list_at(std::string_view key) const {
  const model::TomlEntry* entry = find(key);
  if (entry == nullptr) return {};
  const auto* list = std::get_if<std::vector<model::TomlItem>>(&entry->value);
  if (list == nullptr || list->empty()) refuse(entry->line, entry->key, "must be a list with at least one entry");
  return *list;
}

std::vector<std::string> StudyEntries::texts_at(std::string_view key) const {
  const model::TomlEntry* entry = find(key);
  if (entry == nullptr) return {};
  if (const auto* text = std::get_if<std::string>(&entry->value)) return {*text};
  std::vector<std::string> texts;
  for (const model::TomlItem& item : list_at(key)) {
    const auto* text = std::get_if<std::string>(&item);
    if (text == nullptr) refuse(entry->line, entry->key, "must be texts in quotes");
    texts.push_back(*text);
  }
  return texts;
}

std::optional<double> StudyEntries::length_at(std::string_view key) const {
  const model::TomlEntry* entry = find(key);
  if (entry == nullptr) return std::nullopt;
  const std::string text = text_at(key, "");
  try {
    const double length = base::parse_quantity(text, base::Dimension::length);
    if (length > 0) return length;
  } catch (const InputError& error) {
    refuse(entry->line, entry->key, error.what());
  }
  refuse(entry->line, entry->key, "must be more than 0 mm");
}

}  // namespace knitmech::study
