#include "app/open_browser.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <system_error>

#include "base/errors.h"
#include "base/text.h"
#include "results/atomic_file.h"

// Of the environment that a program hands on to another; POSIX has it in no header.
extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;

/// Nothing in this program changes its environment, so that reading it is safe on any thread.
const char* variable(const char* name) {
  return std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
}

bool has_screen() {
  return variable("DISPLAY") != nullptr || variable("WAYLAND_DISPLAY") != nullptr;
}

/// A new folder that only this user can look into; empty if there can be none.
fs::path private_folder() {
  const char* const own = variable("XDG_RUNTIME_DIR");
  std::error_code error;
  const fs::path parent =
      own != nullptr && fs::is_directory(own, error) ? fs::path(own) : fs::temp_directory_path(error);
  std::string name = (parent / "knitmech-XXXXXX").string();
  return mkdtemp(name.data()) == nullptr ? fs::path() : fs::path(name);
}

/// Whether a program could be started; its words go nowhere.
bool start(const char* program, std::string argument) {
  posix_spawn_file_actions_t silence;
  posix_spawn_file_actions_init(&silence);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&silence, stream, "/dev/null", O_RDWR, 0);
  }
  std::string name = program;
  const std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int code = posix_spawnp(&child, program, &silence, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&silence);
  int status = 0;
  return code == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

OpenedBrowser::OpenedBrowser(const std::string& address) {
  if (!has_screen()) return;
  folder_ = private_folder();
  if (folder_.empty()) return;
  const fs::path file = folder_ / "open.html";
  try {
    results::write_file_atomically(
        file, fmt::format("<!doctype html><meta charset=\"utf-8\"><title>KnitMech</title>"
                          "<meta http-equiv=\"refresh\" content=\"0;url={0}\"><a href=\"{0}\">KnitMech</a>\n",
                          base::in_markup(address)));
  } catch (const FileError&) {
    return;  // the address is printed in any case
  }
  opened_ = start("xdg-open", file.string());
}

OpenedBrowser::~OpenedBrowser() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

}  // namespace knitmech::app
