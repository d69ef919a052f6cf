#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

#include "app/commands.h"
#include "app/compare_texts.h"
#include "app/curve_results.h"
#include "app/option_quantity.h"
#include "base/errors.h"
#include "base/text.h"
#include "compare/comparison_files.h"
#include "compare/comparison_table.h"
#include "picture/comparison_chart.h"
#include "results/atomic_file.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;
using base::Dimension;

double length_of(const char* option, const std::string& text, double otherwise) {
  const double length = option_quantity(option, text, Dimension::length).value_or(otherwise);
  if (!(length > 0)) throw InputError(fmt::format("{}: must be more than 0", option));
  return length;
}

compare::ComparisonSettings settings_from(const CompareOptions& options) {
  compare::ComparisonSettings settings{.at = options.at};
  if (options.offset == "auto") {
    settings.finds_offset = true;
  } else if (!options.offset.empty()) {
    const char* const end = options.offset.data() + options.offset.size();
    const auto [stop, error] = std::from_chars(options.offset.data(), end, settings.offset);
    if (error != std::errc{} || stop != end || !std::isfinite(settings.offset)) {
      throw InputError(fmt::format("--offset: {} is no strain; write a number such as 0.02, or auto",
                                   base::in_quotes(options.offset)));
    }
  }
  return settings;
}

ComparedRun compare_run(const CompareOptions& options) {
  const compare::ComparisonSettings settings = settings_from(options);
  ComparedRun compared;
  compared.run = options.run;
  compared.simulated = compare::read_simulated_curve(options.run);
  compared.facts = {.gauge_length = length_of("--gauge-length", options.gauge_length, compared.simulated.gauge_length),
                    .width = length_of("--width", options.width, compared.simulated.width),
                    .columns = {.load = options.load_column, .extension = options.extension_column},
                    .samples = options.samples};
  compared.measured = compare::read_measured_curve(options.files, compared.facts);
  compared.comparison = compare::compare(compared.simulated, compared.measured.mean, settings);
  return compared;
}

void write_results(const fs::path& folder, const ComparedRun& compared, const std::vector<std::string>& files) {
  make_curve_folder(folder, {compare::kCompareTable, compare::kCompareJson, compare::kCompareChart}, files);
  const double width = compared.same_width() ? compared.simulated.width : 0;
  results::write_file_atomically(folder / compare::kCompareTable, compare::comparison_table(compared.comparison));
  results::write_file_atomically(folder / compare::kCompareJson, compare_json(compared, folder) + "\n");
  results::write_file_atomically(
      folder / compare::kCompareChart,
      picture::chart_svg(picture::comparison_chart(compared.comparison, compared.simulated.title, width)));
}

}  // namespace

ExitCode run_command(const CompareOptions& options) {
  const ComparedRun compared = compare_run(options);
  const fs::path folder =
      options.folder.empty() ? fs::path(options.run) / compare::kCompareFolder : fs::path(options.folder);
  write_results(folder, compared, options.files);
  if (options.json) {
    fmt::print("{}\n", compare_json(compared, folder));
  } else {
    fmt::print("{}Results: {}\n  {}, {}, {}\n", compare_text(compared), folder.string(), compare::kCompareTable,
               compare::kCompareJson, compare::kCompareChart);
  }
  return kDone;
}

}  // namespace knitmech::app
