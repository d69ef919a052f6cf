#include "app/render_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/run_texts.h"
#include "base/errors.h"
#include "model/yarn_curve.h"
#include "picture/frame_between.h"
#include "picture/webp_film.h"
#include "results/atomic_file.h"
#include "results/read_frame.h"

namespace knitmech::app {
namespace {

namespace fs = std::filesystem;
using picture::Extent;
using picture::PictureOptions;
using results::StoredRun;

/// Pause at the end of a stretch [s].
constexpr double kPause = 1;

/// Stored frames below which a stretch looks like straight lines [-].
constexpr std::size_t kFewFrames = 8;

int n_pictures(const FilmTimes& times) {
  constexpr double kMost = 10000;
  const double count = std::round(times.pictures_per_second * times.seconds);
  if (!(count >= 2 && count <= kMost)) {
    throw InputError(fmt::format("{} s of {} pictures per second make no film of 2 to {} pictures", times.seconds,
                                 times.pictures_per_second, kMost));
  }
  return static_cast<int>(count);
}

/// Writes the pictures that `draw` gives for 0, 1, 2, ...
void write_film(const fs::path& file, const FilmTimes& times, double pause, std::ostream& messages,
                const std::function<picture::Image(int)>& draw) {
  const int count = n_pictures(times);
  picture::WebpFilm film(times.pictures_per_second);
  messages << fmt::format("Drawing {} pictures\n", count) << std::flush;
  int width = 0;
  int height = 0;
  for (int i = 0; i < count; ++i) {
    const picture::Image image = draw(i);
    width = image.width();
    height = image.height();
    film.add(image);
  }
  const std::string bytes = film.finish(pause);
  results::write_file_atomically(file, bytes);
  messages << fmt::format("Wrote {}: {} x {} px, {:.1f} s, {:.2g} MB\n", file.string(), width, height,
                          count / times.pictures_per_second + pause, 1e-6 * static_cast<double>(bytes.size()));
}

Extent extent_of(const model::Model& model, const model::Frame& frame, const picture::ViewAxes& axes) {
  const std::vector<model::CurvePiece> pieces = model::yarn_curves(model, frame);
  if (pieces.empty()) {
    throw InputError(fmt::format("frame {} has no yarn whose position is known; leave it out", frame.index));
  }
  return picture::extent_along(axes, pieces);
}

/// Around all stored frames.
Extent extent_of(const StoredRun& run, const picture::ViewAxes& axes) {
  Extent extent = extent_of(run.model, results::read_frame(run, run.frames.front().index), axes);
  for (const results::StoredFrame& stored : run.frames) {
    extent = picture::around(extent, extent_of(run.model, results::read_frame(run, stored.index), axes));
  }
  return extent;
}

/// Hands out the frame at a strain; strains must not fall from one to the next, so that each file is read once.
class FramesBetween {
 public:
  explicit FramesBetween(const StoredRun& run)
      : run_(run),
        before_(results::read_frame(run, run.frames[0].index)),
        after_(results::read_frame(run, run.frames[1].index)) {}

  [[nodiscard]] model::Frame at(double strain) {
    while (strain > after_.history.strain && next_ < run_.frames.size()) {
      before_ = std::move(after_);
      after_ = results::read_frame(run_, run_.frames[next_].index);
      ++next_;
    }
    const double length = after_.history.strain - before_.history.strain;
    const double share = length > 0 ? (strain - before_.history.strain) / length : 1;
    return picture::frame_between(before_, after_, std::clamp(share, 0.0, 1.0));
  }

 private:
  const StoredRun& run_;
  model::Frame before_, after_;
  std::size_t next_ = 2;
};

/// Extents about one middle, as wide and high for every direction of a turn as the widest asks for.
class TurningExtents {
 public:
  TurningExtents(const model::Model& model, const model::Frame& frame, picture::View view, int n_directions) {
    const Extent upright = extent_of(model, frame, picture::axes_of(picture::View::front));
    middle_ = 0.5 * (upright.lowest + upright.highest);
    const std::vector<model::CurvePiece> pieces = model::yarn_curves(model, frame);
    for (int i = 0; i < n_directions; ++i) {
      const picture::ViewAxes axes = picture::axes_of(view, 360.0 * i / n_directions);
      const Extent extent = picture::extent_along(axes, pieces);
      const Eigen::Vector3d middle = middle_along(axes);
      half_size_ = half_size_.cwiseMax(extent.highest - middle).cwiseMax(middle - extent.lowest);
    }
  }

  [[nodiscard]] Extent along(const picture::ViewAxes& axes) const {
    const Eigen::Vector3d middle = middle_along(axes);
    return {middle - half_size_, middle + half_size_};
  }

 private:
  [[nodiscard]] Eigen::Vector3d middle_along(const picture::ViewAxes& axes) const {
    return {middle_.dot(axes.right), middle_.dot(axes.up), middle_.dot(axes.towards_viewer)};
  }

  Eigen::Vector3d middle_{0, 0, 0}, half_size_{0, 0, 0};
};

/// Of all captions of a run the one with the most letters: the width of the pictures must not depend on them.
std::string longest_caption(const std::vector<std::string>& captions) {
  return *std::max_element(captions.begin(), captions.end(),
                           [](const std::string& a, const std::string& b) { return a.size() < b.size(); });
}

/// Soft shadows come out of the compression of films in blocks.
PictureOptions without_shadow(PictureOptions options) {
  options.has_shadow_on_backdrop = false;
  return options;
}

}  // namespace

void write_stretch_film(const fs::path& file, const StoredRun& run, const PictureOptions& options,
                        const FilmTimes& times, std::ostream& messages) {
  if (run.frames.size() < 2) {
    throw InputError(fmt::format("the run in {} has stored one frame only; a stretch needs two", run.dir.string()));
  }
  if (run.frames.size() < kFewFrames) {
    messages << fmt::format(
        "{} frames are stored; between them nodes go in straight lines. output.frames_at of the case stores more.\n",
        run.frames.size());
  }
  const int count = n_pictures(times);
  const double first = run.frames.front().strain;
  const double last = run.frames.back().strain;
  std::vector<double> strains;
  std::vector<std::string> captions;
  for (int i = 0; i < count; ++i) {
    strains.push_back(first + (last - first) * i / (count - 1));
    const double force = picture::row_at_strain(run.history, strains.back()).force_top;
    captions.push_back(fmt::format("{:.1f} % strain, {}", 100 * strains.back(), force_text(force)));
  }
  PictureOptions one = without_shadow(options);
  one.extent = extent_of(run, picture::axes_of(options.view));
  one.caption = longest_caption(captions);
  FramesBetween frames(run);
  one.width = picture::picture_width(run.model, frames.at(first), one);
  write_film(file, times, kPause, messages, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    one.caption = captions[at];
    return picture::draw_fabric(run.model, frames.at(strains[at]), one);
  });
}

void write_turn_film(const fs::path& file, const model::Model& model, const model::Frame& frame,
                     const PictureOptions& options, const FilmTimes& times, std::ostream& messages) {
  const int count = n_pictures(times);
  const TurningExtents extents(model, frame, options.view, count);
  PictureOptions one = without_shadow(options);
  write_film(file, times, 0, messages, [&](int i) {
    one.turn = 360.0 * i / count;
    one.extent = extents.along(picture::axes_of(one.view, one.turn));
    return picture::draw_fabric(model, frame, one);
  });
}

}  // namespace knitmech::app
