#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <system_error>

#include "app/commands.h"
#include "base/errors.h"
#include "base/text.h"
#include "results/atomic_file.h"
#include "run/export_case.h"
#include "run/load_case.h"

namespace knitmech::app {
ExitCode run_command(const ExportOptions& options) {
  const run::LoadedCase loaded = run::load_case(options.case_file);
  const std::string text = run::exported(loaded, options.format);
  if (options.file.empty()) {
    std::cout << text << std::flush;
    return kDone;
  }
  std::error_code not_there;
  if (std::filesystem::equivalent(options.file, options.case_file, not_there)) {
    throw InputError(fmt::format("{} is the case file itself; give another name", base::in_quotes(options.file)));
  }
  results::write_file_atomically(options.file, text);
  fmt::print("Wrote {}: {} nodes, {} elements\n", options.file, loaded.model.n_nodes(), loaded.model.n_elements());
  return kDone;
}

}  // namespace knitmech::app
