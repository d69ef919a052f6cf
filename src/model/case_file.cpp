#include "model/case_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "base/text.h"
#include "model/case_of_file.h"
#include "model/case_rules.h"
#include "model/parameter_value.h"
#include "model/parameters.h"
#include "model/parameters_text.h"
#include "model/toml_entries.h"

namespace knitmech::model {
namespace {

constexpr std::size_t kLargestFile = 1'000'000;  // [bytes]

/// "my.toml, line 3: loop.height: must be ...", without the key where the complaint names it itself.
std::string message(const std::string& file, int line, const std::string& key, const std::string& complaint) {
  const bool key_is_named = key.empty() || complaint.find(key) != std::string::npos;
  const std::string place = line > 0 ? fmt::format("{}, line {}", file, line) : file;
  return fmt::format("{}: {}{}", place, key_is_named ? "" : key + ": ", complaint);
}

/// The entries of one file and what was found in them so far.
struct Reading {
  std::string file;
  std::vector<TomlEntry> entries;
  Case result = default_case();
  std::vector<CaseFileError> mistakes{};

  void note(int line, const std::string& key, const std::string& complaint) {
    mistakes.emplace_back(file, line, key, complaint);
  }
};

const TomlEntry* find_entry(const std::vector<TomlEntry>& entries, std::string_view key) {
  const auto found = std::ranges::find(entries, key, &TomlEntry::key);
  return found == entries.end() ? nullptr : &*found;
}

int nearest_line(const std::vector<TomlEntry>& entries, std::string_view key) {
  if (const TomlEntry* entry = find_entry(entries, key)) return entry->line;
  const std::string_view section = section_name_of(key);
  const TomlEntry* head = section.empty() ? nullptr : find_entry(entries, section);
  return head == nullptr ? 0 : head->line;
}

bool is_section(std::string_view name) {
  return std::ranges::find(sections(), name, &CaseSection::name) != sections().end();
}

std::vector<std::string_view> section_names() {
  std::vector<std::string_view> names;
  for (const CaseSection& section : sections()) {
    if (!section.name.empty()) names.push_back(section.name);
  }
  return names;
}

/// The keys of a section, without its name.
std::vector<std::string_view> names_in(std::string_view section) {
  std::vector<std::string_view> names;
  for (const Parameter& each : parameters()) {
    if (section_name_of(each.key) == section) names.push_back(name_of(each.key));
  }
  return names;
}

/// Where an unknown key would be right: another section that has it, or a key that is spelt nearly so.
std::string advice_on_key(std::string_view key) {
  const std::string_view section = section_name_of(key);
  for (const Parameter& each : parameters()) {
    if (name_of(each.key) != name_of(key)) continue;
    if (section_name_of(each.key).empty()) return fmt::format("{} stands at the top of the file", each.key);
    return fmt::format("{} belongs to [{}]", name_of(key), section_name_of(each.key));
  }
  const auto known = names_in(section);
  const std::string_view nearest = base::nearest_word(name_of(key), known);
  if (!nearest.empty()) return fmt::format("did you mean {}?", nearest);
  if (section.empty()) return fmt::format("the sections of a case file are {}", base::alternatives(section_names()));
  return fmt::format("the keys of [{}] are {}", section, base::alternatives(known));
}

bool names_yarn_file(const Reading& reading) {
  return find_entry(reading.entries, "fabric.yarns") != nullptr;
}

void check_section(Reading& reading, const TomlEntry& entry) {
  if (is_section(entry.key)) return;
  if (find_parameter(entry.key) != nullptr) {
    reading.note(entry.line, entry.key, "is a section, but must be a value");
    return;
  }
  const auto nearest = base::nearest_word(entry.key, section_names());
  reading.note(entry.line, {},
               nearest.empty() ? fmt::format("there is no section [{}]; the sections are {}", entry.key,
                                             base::alternatives(section_names()))
                               : fmt::format("there is no section [{}]; did you mean [{}]?", entry.key, nearest));
}

void take_value(Reading& reading, const TomlEntry& entry) {
  if (is_section(entry.key)) {
    reading.note(entry.line, entry.key, fmt::format("is a value, but must be a section; write [{}]", entry.key));
    return;
  }
  const Parameter* parameter = find_parameter(entry.key);
  if (parameter == nullptr) {
    reading.note(entry.line, base::in_quotes(entry.key), "there is no such key; " + advice_on_key(entry.key));
    return;
  }
  if (const std::string complaint = complaint_about_fabric(*parameter, names_yarn_file(reading)); !complaint.empty()) {
    reading.note(entry.line, entry.key, complaint);
    return;
  }
  try {
    set_value(reading.result, *parameter, value_from(*parameter, entry.value));
  } catch (const InputError& error) {
    reading.note(entry.line, entry.key, error.what());
  }
}

void check_nothing_missing(Reading& reading) {
  for (const Parameter& parameter : parameters()) {
    if (parameter.need != Need::required || find_entry(reading.entries, parameter.key) != nullptr) continue;
    if (parameter.from == FabricFrom::loops && names_yarn_file(reading)) continue;
    const std::string_view section = section_name_of(parameter.key);
    const std::string where = section.empty() ? "at the top of the file" : fmt::format("in [{}]", section);
    reading.note(nearest_line(reading.entries, parameter.key), std::string(parameter.key),
                 fmt::format("is missing; write for example {} {} ({})", example_of(parameter), where, parameter.help));
  }
}

void check_rules(Reading& reading) {
  const auto broken = broken_rule(reading.result);
  if (!broken) return;
  reading.note(nearest_line(reading.entries, broken->key), broken->key, broken->complaint);
}

/// Reads the file of yarns that the case names.
void take_yarn_file(Reading& reading, const std::optional<std::filesystem::path>& folder) {
  const TomlEntry* entry = find_entry(reading.entries, "fabric.yarns");
  if (entry == nullptr) return;
  try {
    read_yarn_file_of(reading.result, folder);
  } catch (const InputError& error) {
    reading.note(entry->line, entry->key, error.what());
  } catch (const FileError& error) {
    throw FileError(message(reading.file, entry->line, entry->key, error.what()));
  }
}

void check_is_text(std::string_view text, const std::string& file) {
  if (text.size() > kLargestFile) {
    throw CaseFileError(file, 0, {}, fmt::format("is larger than {} bytes and so no case file", kLargestFile));
  }
  if (text.find('\0') != std::string_view::npos) {
    throw CaseFileError(file, 0, {}, "is not a text file; a case file is TOML text, `knitmech new` writes one");
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw CaseFileError(file, 0, {}, "is empty; `knitmech new` writes a case file to start from");
  }
}

/// @throws CaseFileError for what is no text and no TOML
Reading read_all(std::string_view text, const std::string& file, const std::optional<std::filesystem::path>& folder) {
  check_is_text(text, file);
  Reading reading{.file = file, .entries = {}};
  try {
    reading.entries = toml_entries(text);
  } catch (const TomlSyntaxError& error) {
    throw CaseFileError(file, error.line(), {}, error.what());
  }
  for (const TomlEntry& entry : reading.entries) {
    if (std::holds_alternative<TomlSection>(entry.value)) {
      check_section(reading, entry);
    } else {
      take_value(reading, entry);
    }
  }
  check_nothing_missing(reading);
  if (!reading.mistakes.empty()) return reading;
  if (find_entry(reading.entries, "output.frames_at") == nullptr) cut_frames_to_test(reading.result);
  check_rules(reading);
  if (reading.mistakes.empty()) take_yarn_file(reading, folder);
  return reading;
}

std::string section_text(const Case& input, const CaseSection& section) {
  std::string text;
  for (const Parameter& parameter : parameters()) {
    if (section_name_of(parameter.key) != section.name || !applies_to(parameter, input)) continue;
    const Value value = value_in(input, parameter);
    const bool not_given = parameter.need == Need::optional && std::holds_alternative<std::monostate>(value);
    // Of a test that ends before the first default frame; a file may not say so.
    const auto* list = std::get_if<std::vector<double>>(&value);
    const bool is_empty = list != nullptr && list->empty();
    if (!not_given && !is_empty) text += fmt::format("{}  # {}\n", assignment(parameter, value), parameter.help);
  }
  return section.name.empty() || text.empty() ? text : fmt::format("\n[{}]\n{}", section.name, text);
}

}  // namespace

CaseFileError::CaseFileError(std::string file, int line, std::string key, const std::string& complaint)
    : InputError(message(file, line, key, complaint)),
      file_(std::move(file)),
      line_(line),
      key_(std::move(key)),
      complaint_(complaint) {}

Case parse_case(std::string_view text, const std::string& file, const std::optional<std::filesystem::path>& folder) {
  Reading reading = read_all(text, file, folder);
  if (!reading.mistakes.empty()) throw CaseFileError(reading.mistakes.front());
  return std::move(reading.result);
}

std::vector<CaseFileError> mistakes_in(std::string_view text, const std::string& file) {
  try {
    return read_all(text, file, std::nullopt).mistakes;
  } catch (const CaseFileError& error) {
    return {error};
  }
}

std::string case_file_text(const std::filesystem::path& path) {
  const auto refuse = [&](const char* reason) {
    throw FileError(fmt::format("cannot read {}: {}", base::in_quotes(path.string()), reason));
  };
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) refuse("there is no such file");
  if (std::filesystem::is_directory(path, ignored)) refuse("it is a folder; give the case file in it");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse("the file cannot be opened");
  std::string text(kLargestFile + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) refuse("reading failed");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  check_is_text(text, path.string());
  return text;
}

Case read_case_file(const std::filesystem::path& path) {
  return parse_case(case_file_text(path), path.string(), path.parent_path());
}

std::string write_case(const Case& input) {
  std::string text;
  for (const CaseSection& section : sections()) text += section_text(input, section);
  return text;
}

int line_of_key(std::string_view text, std::string_view key) {
  return nearest_line(toml_entries(text), key);
}

}  // namespace knitmech::model
