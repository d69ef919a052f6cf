#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/curve_results.h"
#include "app/json_text.h"
#include "app/yarn_analysis.h"
#include "app/yarn_pictures.h"
#include "app/yarn_texts.h"
#include "picture/chart.h"
#include "results/atomic_file.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSectionFile = "yarn.toml";
constexpr const char* kChartFile = "yarn.svg";
constexpr const char* kMeanFile = "mean-curve.csv";

/// results/polyamide for some/where/polyamide.csv
fs::path folder_of(const YarnOptions& options) {
  return options.folder.empty() ? "results" / fs::path(options.files.front()).stem() : fs::path(options.folder);
}

void write_results(const fs::path& folder, const YarnAnalysis& analysis, const std::string& block,
                   const std::vector<std::string>& files) {
  make_curve_folder(folder, {kSectionFile, kChartFile, kMeanFile}, files);
  results::write_file_atomically(folder / kMeanFile, mean_curve_csv(analysis.mean));
  results::write_file_atomically(folder / kChartFile, picture::chart_svg(yarn_chart(analysis)));
  if (!block.empty()) {
    results::write_file_atomically(folder / kSectionFile, block);
  } else {
    fs::remove(folder / kSectionFile);  // one of an earlier call, which would not belong to these curves
  }
}

}  // namespace

ExitCode run_command(const YarnOptions& options) {
  const YarnAnalysis analysis = analyse_yarn(options);
  const std::string block = yarn_section_block(analysis);
  const fs::path folder = folder_of(options);
  write_results(folder, analysis, block, options.files);
  if (options.json) {
    fmt::print("{}\n", yarn_json(analysis, block, folder));
    return kDone;
  }
  fmt::print("{}", yarn_text(analysis));
  if (block.empty()) {
    fmt::print(
        "Results: {}\n  {}, {}; a section for a case file needs two of --diameter, --density and "
        "--linear-density\n",
        folder.string(), kMeanFile, kChartFile);
  } else {
    fmt::print("Results: {}\n  {}, {}, {}:\n\n{}", folder.string(), kMeanFile, kChartFile, kSectionFile, block);
  }
  return kDone;
}

}  // namespace knitmech::app
