#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

#include "app/commands.h"
#include "app/picture_words.h"
#include "app/run_texts.h"
#include "base/errors.h"
#include "base/text.h"
#include "picture/fabric_picture.h"
#include "results/read_frame.h"
#include "results/read_run.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;
using picture::ColourBy;
using picture::PictureOptions;
using results::StoredFrame;
using results::StoredRun;

/// The frame that is asked for; says which one was taken for a strain.
int chosen_frame(const StoredRun& run, const RenderOptions& options) {
  if (options.frame) return *options.frame;
  if (!options.strain) return run.frames.back().index;
  const StoredFrame& nearest = results::nearest_frame(run, *options.strain);
  fmt::print("Frame {} at {} strain is the stored one nearest to {}.\n", nearest.index, percent_text(nearest.strain),
             percent_text(*options.strain));
  return nearest.index;
}

/// The ends of the colours for all stored frames.
std::pair<double, double> range_of_all(const StoredRun& run, ColourBy colour_by) {
  picture::ValueRange values;
  for (const StoredFrame& stored : run.frames) {
    const model::Frame frame = results::read_frame(run, stored.index);
    if (const auto field = picture::yarn_field(colour_by, run.model, frame, {})) values.include(*field);
  }
  return picture::round_range(colour_by, values);
}

PictureOptions picture_options(const StoredRun& run, const RenderOptions& options) {
  PictureOptions picture;
  picture.colour_by = colour_by_word(options.colour);
  picture.view = view_by_word(options.view);
  picture.width = options.width;
  if (options.height) picture.height = *options.height;
  if (!options.window.empty()) {
    picture.window = {options.window[0], options.window[1], options.window[2], options.window[3]};
  }
  if (!options.range.empty()) picture.range = {options.range[0], options.range[1]};
  if (options.same_range) picture.range = range_of_all(run, picture.colour_by);
  return picture;
}

void make_folder_of(const fs::path& file) {
  std::error_code code;
  fs::create_directories(file.parent_path(), code);
  if (code) throw FileError(fmt::format("cannot write the folder {}: {}", file.parent_path().string(), code.message()));
}

/// Where a picture goes: where the user says, or into the folder pictures/ of the run under a name.
fs::path picture_file(const RenderOptions& options, const std::string& name) {
  if (options.file.empty()) {
    const fs::path file = fs::path(options.run) / "pictures" / name;
    make_folder_of(file);
    return file;
  }
  const fs::path wanted = fs::path(name).extension();
  if (fs::path(options.file).extension() != wanted) {
    throw InputError(fmt::format("{} cannot be written: the picture is a {} file; let its name end so",
                                 base::in_quotes(options.file), wanted.string()));
  }
  return options.file;
}

void check(const RenderOptions& options) {
  if (options.strain && !std::isfinite(*options.strain)) throw InputError("--strain should be a number, as 0.16");
}

}  // namespace

ExitCode run_command(const RenderOptions& options) {
  check(options);
  const StoredRun run = results::read_run(options.run);
  PictureOptions picture = picture_options(run, options);
  const model::Frame frame = results::read_frame(run, chosen_frame(run, options));
  picture.caption =
      fmt::format("{} strain, {}", percent_text(frame.history.strain), force_text(frame.history.force_top));
  const fs::path file =
      picture_file(options, fmt::format("frame_{:04}-{}-{}.png", frame.index, options.colour, options.view));
  picture::write_fabric_picture(file, run.model, frame, picture);
  fmt::print("Wrote {}: frame {}, {}\n", file.string(), frame.index, picture.caption);
  return kDone;
}

}  // namespace knitmech::app
