#include "serve/run_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "results/atomic_file.h"
#include "serve/refusal.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;

constexpr std::array kTypes{std::pair{".html", "text/html; charset=utf-8"},
                            std::pair{".svg", "image/svg+xml"},
                            std::pair{".png", "image/png"},
                            std::pair{".webp", "image/webp"},
                            std::pair{".csv", "text/csv; charset=utf-8"},
                            std::pair{".json", "application/json"},
                            std::pair{".toml", "text/plain; charset=utf-8"},
                            std::pair{".txt", "text/plain; charset=utf-8"}};

std::string type_of(const fs::path& file) {
  for (const auto& [extension, type] : kTypes) {
    if (file.extension() == extension) return type;
  }
  return "application/octet-stream";
}

bool has_hidden_part(const fs::path& path) {
  return std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part.string().starts_with('.'); });
}

}  // namespace

RunFile read_run_file(const fs::path& folder, const std::string& path) {
  const auto refuse = [&] { throw Refusal(404, fmt::format("there is no file {} in the run", base::in_quotes(path))); };
  const bool is_name = !path.empty() && path.find('\0') == std::string::npos && !fs::path(path).is_absolute();
  if (!is_name || has_hidden_part(path)) refuse();
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  const fs::path file = error ? fs::path() : fs::canonical(folder / path, error);
  if (error || !fs::is_regular_file(file) || file.lexically_relative(root).string().starts_with("..")) refuse();
  if (fs::file_size(file) > kLargestFile) {
    throw Refusal(413, fmt::format("{} is too large for the page; take it from the run folder", base::in_quotes(path)));
  }
  return {results::read_file(file), type_of(file)};
}

}  // namespace knitmech::serve
