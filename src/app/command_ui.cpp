#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <thread>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/open_browser.h"
#include "base/errors.h"
#include "base/text.h"
#include "results/summary.h"
#include "serve/server.h"
#include "serve/workspace.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kLookInterval{100};

bool is_run(const fs::path& path) {
  return results::is_summary(path / results::kSummaryFile);
}

/// A case is edited in the present folder if it is in it, else in its own.
void open_case(const fs::path& file, serve::ServerSettings& settings) {
  if (auto path = serve::Workspace(settings.folder).relative(file)) {
    settings.opened_case = std::move(path);
    return;
  }
  settings.folder = fs::canonical(file).parent_path();
  settings.opened_case = file.filename().string();
}

/// What is named on the command line is opened, and with it its folder.
void open_named(const fs::path& named, serve::ServerSettings& settings) {
  if (is_run(named)) {
    const fs::path run = fs::canonical(named);
    settings.opened_run = run.filename().string();
    settings.runs_folder = run.parent_path();
    return;
  }
  std::error_code error;
  if (fs::is_directory(named, error)) {
    throw InputError(fmt::format("{} is a folder, but not of a run; with --folder it is the one to work in",
                                 base::in_quotes(named.string())));
  }
  if (!fs::is_regular_file(named, error)) {
    throw FileError(fmt::format("cannot read {}: there is no such file", base::in_quotes(named.string())));
  }
  if (named.extension() != ".toml") {
    throw InputError(fmt::format("{} is no case file; its name would end with .toml", base::in_quotes(named.string())));
  }
  open_case(named, settings);
}

serve::ServerSettings settings_of(const UiOptions& options) {
  serve::ServerSettings settings;
  settings.folder = options.folder.empty() ? fs::current_path() : fs::path(options.folder);
  settings.host = options.host;
  settings.port = options.port;
  settings.version = KNITMECH_VERSION;
  if (!options.named.empty()) open_named(options.named, settings);
  if (settings.runs_folder.empty()) settings.runs_folder = settings.folder / "results";
  return settings;
}

void wait_for_interrupt() {
  while (!InterruptWatch::requested()) std::this_thread::sleep_for(kLookInterval);
}

}  // namespace

ExitCode run_command(const UiOptions& options) {
  const serve::ServerSettings settings = settings_of(options);
  const serve::Server server(settings);
  const InterruptWatch watch;  // before the address is told: who knows it may end the program
  fmt::print("KnitMech's page: {}\n  cases   {}\n  runs    {}\n", server.address(), settings.folder.string(),
             settings.runs_folder.string());
  fmt::print("Ctrl-C ends the program; what runs then is kept and can go on later.\n");
  std::fflush(stdout);
  if (options.browser) {
    const OpenedBrowser browser(server.address());
    if (!browser.opened()) {
      fmt::print("No browser could be opened; open the address above in one.\n");
      std::fflush(stdout);
    }
    wait_for_interrupt();
  } else {
    wait_for_interrupt();
  }
  fmt::print("Ending.\n");
  return kDone;
}

}  // namespace knitmech::app
