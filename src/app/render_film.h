#pragma once

#include <filesystem>
#include <iosfwd>

#include "model/frame.h"
#include "picture/fabric_picture.h"
#include "results/read_run.h"

namespace knitmech::app {

inline constexpr int kFilmHeight = 720;  ///< [px]

struct FilmTimes {
  double pictures_per_second = 20;
  double seconds = 4;  ///< that the film takes, the pause at its end apart
};

/// Films as animated WebP that go round for ever; what is drawn is as in `options`, but for its extent, which is the
/// same in all pictures. They say on `messages` what they do and write. Throw InputError for times that make no
/// film of 2 to 10000 pictures.
///
/// The stretch of the fabric: strain grows evenly from the first stored frame to the last one. Between two stored
/// frames every node goes in a straight line; the force of the caption is that of the history. Then the film pauses.
void write_stretch_film(const std::filesystem::path& file, const results::StoredRun& run,
                        const picture::PictureOptions& options, const FilmTimes& times, std::ostream& messages);

/// One frame that turns once about y.
void write_turn_film(const std::filesystem::path& file, const model::Model& model, const model::Frame& frame,
                     const picture::PictureOptions& options, const FilmTimes& times, std::ostream& messages);

}  // namespace knitmech::app
