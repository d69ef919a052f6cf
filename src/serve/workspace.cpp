#include "serve/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/text.h"
#include "model/case_file.h"
#include "model/parameters_text.h"
#include "model/toml_entries.h"
#include "results/atomic_file.h"
#include "results/summary.h"
#include "serve/examples.h"
#include "serve/refusal.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kDeepest = 4;                      ///< folders below the folder in which cases are looked for
constexpr std::size_t kMostCases = 500;          ///< that are listed
constexpr std::size_t kMostEntries = 20000;      ///< files and folders that are looked at for them
constexpr std::size_t kLongestPath = 400;        ///< [bytes]
constexpr std::size_t kLargestCase = 1'000'000;  ///< [bytes], that can be read again

Json case_text(const Json& path, const std::string& text, const Json& stamp) {
  return {{"path", path}, {"text", text}, {"stamp", stamp}};
}

std::string dumped(const Json& document) {
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Of a content: equal for equal contents, different for different ones as far as chance goes. Its time alone would not
/// do: two savings may fall in one tick of the clock.
std::string stamp_of(const std::string& content) {
  return fmt::format("{:x}-{:x}", content.size(), std::hash<std::string>{}(content));
}

/// The title of a text that is a case; empty for any other file.
std::optional<std::string> title_of(std::string_view text) {
  try {
    std::string title;
    bool has_loop = false;
    for (const model::TomlEntry& entry : model::toml_entries(text)) {
      has_loop = has_loop || entry.key == "loop";
      const auto* words = std::get_if<std::string>(&entry.value);
      if (entry.key == "title" && words != nullptr) title = *words;
    }
    if (has_loop) return title;
  } catch (const InputError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

std::optional<std::string> title_in(const fs::path& file) {
  try {
    return title_of(model::case_file_text(file));
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

bool is_passed_over(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  return name.starts_with('.') || name == "node_modules" || entry.is_symlink() ||
         fs::exists(entry.path() / results::kSummaryFile);
}

std::vector<fs::path> toml_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator each(folder, fs::directory_options::skip_permission_denied, error);
  std::size_t n_seen = 0;
  for (; !error && each != fs::recursive_directory_iterator(); each.increment(error)) {
    if (++n_seen > kMostEntries || files.size() == kMostCases) break;
    std::error_code ignored;
    if (each->is_directory(ignored)) {
      if (each.depth() >= kDeepest || is_passed_over(*each)) each.disable_recursion_pending();
    } else if (each->is_regular_file(ignored) && !each->is_symlink(ignored) && each->path().extension() == ".toml") {
      files.push_back(each->path());
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

Workspace::Workspace(const fs::path& folder) {
  std::error_code error;
  folder_ = fs::canonical(folder, error);
  if (error || !fs::is_directory(folder_)) {
    throw FileError(fmt::format("{} is not a folder that can be read", base::in_quotes(folder.string())));
  }
}

std::optional<std::string> Workspace::relative(const fs::path& file) const {
  const std::string path = fs::weakly_canonical(file).lexically_relative(folder_).generic_string();
  if (path.empty() || path == "." || path.starts_with("..")) return std::nullopt;
  return path;
}

std::string Workspace::cases_json() const {
  Json cases = Json::array();
  for (const fs::path& file : toml_files(folder_)) {
    if (const auto title = title_in(file)) {
      cases.push_back({{"path", file.lexically_relative(folder_).generic_string()}, {"title", *title}});
    }
  }
  Json with_program = Json::array();
  for (const Example& each : examples()) {
    with_program.push_back({{"name", each.name}, {"title", title_of(each.text).value_or("")}});
  }
  return dumped({{"cases", cases}, {"examples", with_program}});
}

fs::path Workspace::inside(const std::string& path) const {
  const bool is_name = !path.empty() && path.size() <= kLongestPath && path.find('\0') == std::string::npos &&
                       path.find('\\') == std::string::npos && !fs::path(path).is_absolute();
  fs::path file = is_name ? fs::weakly_canonical(folder_ / path) : fs::path();
  if (!is_name || !relative(file)) {
    throw Refusal(404, fmt::format("{} is not in the folder {}", base::in_quotes(path), folder_.string()));
  }
  if (file.extension() != ".toml") {
    throw InputError(fmt::format("{} is no name of a case file; it must end with .toml", base::in_quotes(path)));
  }
  return file;
}

std::string Workspace::case_json(const std::string& path) const {
  const fs::path file = inside(path);
  if (!fs::is_regular_file(file)) throw Refusal(404, fmt::format("there is no file {}", base::in_quotes(path)));
  const std::string text = model::case_file_text(file);
  return dumped(case_text(*relative(file), text, stamp_of(text)));
}

std::string Workspace::example_json(const std::string& name) {
  for (const Example& each : examples()) {
    if (each.name == name) return dumped(case_text(nullptr, std::string(each.text), nullptr));
  }
  throw Refusal(404, fmt::format("there is no example {}", base::in_quotes(name)));
}

std::string Workspace::template_json() {
  return dumped(case_text(nullptr, model::case_template(), nullptr));
}

std::string Workspace::save(const std::string& path, const std::string& text,
                            const std::optional<std::string>& stamp) const {
  const fs::path file = inside(path);
  if (text.size() > kLargestCase) throw InputError("the text is too large for a case file");
  if (!fs::is_directory(file.parent_path())) {
    throw InputError(fmt::format("there is no folder for {}; make it first", base::in_quotes(path)));
  }
  const bool is_there = fs::exists(file);
  if (is_there && !fs::is_regular_file(file)) {
    throw InputError(fmt::format("{} is a folder; give another name", base::in_quotes(path)));
  }
  if (is_there && !stamp) throw Refusal(409, fmt::format("{} is there already", base::in_quotes(path)));
  if (is_there && stamp_of(results::read_file(file)) != *stamp) {
    throw Refusal(409, fmt::format("{} has been changed by another program since it was read", base::in_quotes(path)));
  }
  results::write_file_atomically(file, text);
  return dumped({{"stamp", stamp_of(text)}});
}

}  // namespace knitmech::serve
