#include "serve/new_folder.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "base/errors.h"
#include "serve/constants.h"

namespace knitmech::serve {
namespace {

namespace fs = std::filesystem;

bool is_fit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
}

[[noreturn]] void fail(const fs::path& folder, const std::error_code& code) {
  throw FileError(fmt::format("cannot make the folder {}: {}", folder.string(), code.message()));
}

}  // namespace

std::string folder_name(std::string_view name) {
  std::string fit;
  for (const char c : name) {
    const char taken = c == ' ' ? '-' : c;
    const bool leads_up = taken == '.' && (fit.empty() || fit.back() == '.');
    if (is_fit(taken) && !leads_up && fit.size() < kLongestName) fit += taken;
  }
  return fit.empty() ? "run" : fit;
}

fs::path make_new_folder(const fs::path& root, const std::string& name) {
  std::error_code code;
  fs::create_directories(root, code);
  if (code) fail(root, code);
  constexpr mode_t kAccess = 0777;  // less what the user's mask takes away
  for (int i = 1;; ++i) {
    fs::path folder = root / (i == 1 ? name : fmt::format("{}-{}", name, i));
    if (mkdir(folder.c_str(), kAccess) == 0) return folder;
    if (errno != EEXIST) fail(folder, {errno, std::generic_category()});
  }
}

}  // namespace knitmech::serve
