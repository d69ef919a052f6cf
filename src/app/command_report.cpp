#include <fmt/format.h>

#include <cstdio>

#include "app/commands.h"
#include "report/run_report.h"
#include "results/read_run.h"

namespace knitmech::app {

ExitCode run_command(const ReportOptions& options) {
  const results::StoredRun run = results::read_run(options.folder);
  report::write_run_report(run);
  fmt::print("Report: {}\n", (run.dir / report::kReportFile).string());
  return kDone;
}

}  // namespace knitmech::app
