#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/yarn_analysis.h"

namespace knitmech::app {

/// {"error": {"message": ..., "exit_code": ..., and for a mistake in a case file "file", "line", "key"}}
[[nodiscard]] std::string error_json(const std::runtime_error& error, ExitCode code);

/// What `run --json` prints: the summary of the run folder, and where that is.
[[nodiscard]] std::string run_json(const std::string& summary, const std::filesystem::path& folder);

/// What commands print with --json that leave files: {"files": ["results/jersey/report.html"]}.
[[nodiscard]] std::string files_json(const std::vector<std::filesystem::path>& files);

/// What `yarn --json` prints. @param block the section block, empty if there is none
[[nodiscard]] std::string yarn_json(const YarnAnalysis& analysis, const std::string& block,
                                    const std::filesystem::path& folder);

}  // namespace knitmech::app
