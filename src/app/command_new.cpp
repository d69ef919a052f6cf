#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/json_text.h"
#include "base/errors.h"
#include "base/text.h"
#include "model/parameters_text.h"
#include "results/atomic_file.h"

namespace knitmech::app {

ExitCode run_command(const NewOptions& options) {
  const std::string text = model::case_template();
  if (options.file.empty()) {
    if (options.json) throw InputError("new --json tells which file was written; give FILE");
    std::cout << text << std::flush;
    return kDone;
  }
  const std::string name = base::in_quotes(options.file);
  if (std::filesystem::is_directory(options.file)) {
    throw FileError(fmt::format("{} is a folder; give the name of a file", name));
  }
  if (!options.force && std::filesystem::exists(options.file)) {
    throw FileError(fmt::format("{} is there already; give another name, or --force to replace it", name));
  }
  results::write_file_atomically(options.file, text);
  fmt::print("{}\n", options.json ? files_json({options.file})
                                  : fmt::format("Wrote {0}. Next: knitmech check {0}", options.file));
  return kDone;
}

}  // namespace knitmech::app
