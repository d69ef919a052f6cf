#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/toml_entries.h"

namespace knitmech::study {

/// The lines of a study file, with what its readers ask of them. What is wrong ends in model::CaseFileError with file,
/// line and key.
class StudyEntries {
 public:
  /// @throws model::CaseFileError if the text is not TOML
  StudyEntries(std::string_view text, std::filesystem::path path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::vector<model::TomlEntry>& all() const { return entries_; }
  [[nodiscard]] const model::TomlEntry* find(std::string_view key) const;

  [[noreturn]] void refuse(int line, const std::string& key, const std::string& complaint) const;

  /// Where a key is not given, the text or number that stands for it, or nothing.
  [[nodiscard]] std::string text_at(std::string_view key, const std::string& otherwise) const;
  [[nodiscard]] std::int64_t whole_at(std::string_view key, std::int64_t otherwise, std::int64_t least,
                                      std::int64_t greatest) const;
  [[nodiscard]] std::vector<model::TomlItem> list_at(std::string_view key) const;
  /// One text, or a list of them.
  [[nodiscard]] std::vector<std::string> texts_at(std::string_view key) const;
  /// [mm], above 0.
  [[nodiscard]] std::optional<double> length_at(std::string_view key) const;

 private:
  std::filesystem::path path_;
  std::vector<model::TomlEntry> entries_;
};

}  // namespace knitmech::study
