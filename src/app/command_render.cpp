#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>

#include "app/chosen_frame.h"
#include "app/commands.h"
#include "app/json_text.h"
#include "app/render_film.h"
#include "app/run_texts.h"
#include "base/errors.h"
#include "base/text.h"
#include "picture/contact_map.h"
#include "picture/fabric_picture.h"
#include "picture/picture_words.h"
#include "picture/side_profile.h"
#include "results/atomic_file.h"
#include "results/read_frame.h"
#include "results/read_run.h"
#include "run/run_pictures.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;
using picture::ColourBy;
using picture::PictureOptions;
using results::StoredFrame;
using results::StoredRun;

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
  picture.colour_by = knitmech::picture::colour_by_word(options.colour);
  picture.view = knitmech::picture::view_by_word(options.view);
  picture.width = options.width;
  if (options.height) picture.height = *options.height;
  if (!options.window.empty()) {
    picture.window = {options.window[0], options.window[1], options.window[2], options.window[3]};
  }
  if (!options.range.empty()) picture.range = {options.range[0], options.range[1]};
  if (options.same_range || (options.film == "stretch" && options.range.empty()))
    picture.range = range_of_all(run, picture.colour_by);
  return picture;
}

void make_folder_of(const fs::path& file) {
  std::error_code code;
  fs::create_directories(file.parent_path(), code);
  if (code) throw FileError(fmt::format("cannot write the folder {}: {}", file.parent_path().string(), code.message()));
}

/// Where a picture or a film goes: where the user says, or into the folder pictures/ of the run under a name.
fs::path output_file(const RenderOptions& options, const std::string& name) {
  if (options.file.empty()) {
    fs::path file = fs::path(options.run) / "pictures" / name;
    make_folder_of(file);
    return file;
  }
  const fs::path wanted = fs::path(name).extension();
  if (fs::path(options.file).extension() != wanted) {
    throw InputError(fmt::format("{} cannot be written: {} is a {} file; let its name end so",
                                 base::in_quotes(options.file), options.film.empty() ? "the picture" : "a film",
                                 wanted.string()));
  }
  return options.file;
}

/// What has been drawn, and what it tells.
struct Drawn {
  fs::path file;
  int frame = 0;
  std::string caption;
};

/// A map or a chart, as text.
Drawn draw_plan(const StoredRun& run, const RenderOptions& options, std::ostream& messages) {
  const model::Frame frame = results::read_frame(run, chosen_frame(run, options.frame, options.strain, messages));
  const std::string caption = run::caption_of(frame.history);
  const fs::path file = output_file(
      options, fmt::format("frame_{:04}-{}.svg", frame.index, options.contact_map ? "contact-map" : "side-profile"));
  results::write_file_atomically(file, options.contact_map ? picture::contact_map_svg(run.model, frame, caption)
                                                           : picture::side_profile_svg(run.model, frame, caption));
  return {file, frame.index, caption};
}

Drawn draw_picture(const StoredRun& run, const RenderOptions& options, std::ostream& messages) {
  PictureOptions picture = picture_options(run, options);
  const model::Frame frame = results::read_frame(run, chosen_frame(run, options.frame, options.strain, messages));
  picture.caption = run::caption_of(frame.history);
  const fs::path file =
      output_file(options, fmt::format("frame_{:04}-{}-{}.png", frame.index, options.colour, options.view));
  picture::write_fabric_picture(file, run.model, frame, picture);
  return {file, frame.index, picture.caption};
}

/// Returns its file.
fs::path make_film(const StoredRun& run, const RenderOptions& options, std::ostream& messages) {
  PictureOptions picture = picture_options(run, options);
  picture.height = options.height.value_or(kFilmHeight);
  const FilmTimes times{options.pictures_per_second, options.seconds};
  if (options.film == "stretch") {
    fs::path file = output_file(options, fmt::format("film-stretch-{}-{}.webp", options.colour, options.view));
    write_stretch_film(file, run, picture, times, messages);
    return file;
  }
  const model::Frame frame = results::read_frame(run, chosen_frame(run, options.frame, options.strain, messages));
  picture.caption = run::caption_of(frame.history);
  fs::path file =
      output_file(options, fmt::format("film-turn-{}-{}-frame_{:04}.webp", options.colour, options.view, frame.index));
  write_turn_film(file, run.model, frame, picture, times, messages);
  return file;
}

/// Draws what is asked for and returns its file.
fs::path draw(const StoredRun& run, const RenderOptions& options, std::ostream& messages) {
  if (!options.film.empty()) return make_film(run, options, messages);
  const bool is_plan = options.contact_map || options.side_profile;
  Drawn drawn = is_plan ? draw_plan(run, options, messages) : draw_picture(run, options, messages);
  messages << fmt::format("Wrote {}: frame {}, {}\n", drawn.file.string(), drawn.frame, drawn.caption);
  return std::move(drawn.file);
}

}  // namespace

ExitCode run_command(const RenderOptions& options) {
  check_strain(options.strain);
  const StoredRun run = results::read_run(options.run);
  std::ostream silence(nullptr);
  const fs::path file = draw(run, options, options.json ? silence : std::cout);
  if (options.json) fmt::print("{}\n", files_json({file}));
  return kDone;
}

}  // namespace knitmech::app
