#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "app/commands.h"
#include "app/json_text.h"
#include "base/errors.h"
#include "base/text.h"
#include "report/run_report.h"
#include "results/read_run.h"

namespace knitmech::app {

ExitCode run_command(const ReportOptions& options) {
  if (std::filesystem::is_regular_file(std::filesystem::path(options.folder) / "study.json")) {
    throw InputError(
        fmt::format("{} is the folder of a study; the command knitmech study makes its report again, and runs "
                    "nothing that is done",
                    base::in_quotes(options.folder)));
  }
  const results::StoredRun run = results::read_run(options.folder);
  report::write_run_report(run);
  const std::filesystem::path file = run.dir / report::kReportFile;
  fmt::print("{}\n", options.json ? files_json({file}) : "Report: " + file.string());
  return kDone;
}

}  // namespace knitmech::app
