#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>

#include "app/chosen_frame.h"
#include "app/commands.h"
#include "app/json_text.h"
#include "base/errors.h"
#include "base/text.h"
#include "results/atomic_file.h"
#include "results/read_frame.h"
#include "results/read_run.h"
#include "run/export_case.h"
#include "run/load_case.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<run::ExportedFile>;

std::string size_in_words(std::size_t bytes) {
  const double kilobytes = static_cast<double>(bytes) / 1e3;
  return kilobytes < 999.5 ? fmt::format("{:.3g} kB", kilobytes) : fmt::format("{:.4g} MB", kilobytes / 1e3);
}

/// The name of the files without what the format adds: of the file that is asked for, or of the source.
std::string stem_of(const ExportOptions& options, const run::ExportFormat& format) {
  if (options.file.empty()) return fs::path(options.source).stem().string();
  return run::export_stem(options.file, format);
}

/// The files, after what is to be known of them.
Files files_of(const run::ExportSource& source, const run::ExportFormat& format) {
  Files files = run::exported(source, format);
  if (const std::string remark = run::export_remark(source, format); !remark.empty()) {
    std::cerr << fmt::format("Note: {}.\n", remark);
  }
  return files;
}

Files files_of_case(const ExportOptions& options, const run::ExportFormat& format) {
  if (options.frame || options.strain) {
    throw InputError(fmt::format("{} is no folder of a run, so it has no frames", base::in_quotes(options.source)));
  }
  const run::LoadedCase loaded = run::load_case(options.source);
  return files_of({loaded.input, loaded.model, nullptr, stem_of(options, format), options.sides}, format);
}

/// A geometry has the shape of the frame that is asked for, or else of the last one; a deck the shape at the start.
Files files_of_run(const ExportOptions& options, const run::ExportFormat& format) {
  const results::StoredRun stored = results::read_run(options.source);
  const bool wants_frame = options.frame || options.strain || format.kind == run::ExportKind::geometry;
  std::optional<model::Frame> frame;
  if (wants_frame) frame = results::read_frame(stored, chosen_frame(stored, options.frame, options.strain, std::cerr));
  return files_of({stored.input, stored.model, frame ? &*frame : nullptr, stem_of(options, format), options.sides},
                  format);
}

void refuse_to_replace_the_source(const ExportOptions& options, const fs::path& file) {
  std::error_code not_there;
  if (fs::equivalent(file, options.source, not_there)) {
    throw InputError(fmt::format("{} is the case file itself; give another name", base::in_quotes(file.string())));
  }
}

void check_output(const ExportOptions& options, const run::ExportFormat& format) {
  if (!options.file.empty()) return;
  if (options.json) throw InputError("export --json tells which files were written; say where to with -o");
  if (format.endings.size() == 1) return;
  throw InputError(fmt::format("the format {} makes {} files; say where to with -o, as -o {}{}",
                               base::in_quotes(format.name), format.endings.size(), stem_of(options, format),
                               format.endings.front()));
}

}  // namespace

ExitCode run_command(const ExportOptions& options) {
  check_strain(options.strain);
  const run::ExportFormat& format = run::export_format(options.format);
  check_output(options, format);
  const Files files = fs::is_directory(options.source) ? files_of_run(options, format) : files_of_case(options, format);
  if (options.file.empty()) {
    std::cout << files.front().bytes << std::flush;
    return kDone;
  }
  for (const run::ExportedFile& file : files) {
    refuse_to_replace_the_source(options, run::export_path(options.file, format, file.ending));
  }
  std::vector<fs::path> written;
  for (const run::ExportedFile& file : files) {
    written.push_back(run::export_path(options.file, format, file.ending));
    results::write_file_atomically(written.back(), file.bytes);
    if (options.json) continue;
    fmt::print("Wrote {}: {}, {}\n", written.back().string(), format.label, size_in_words(file.bytes.size()));
  }
  if (options.json) fmt::print("{}\n", files_json(written));
  return kDone;
}

}  // namespace knitmech::app
