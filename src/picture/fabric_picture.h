#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "model/frame.h"
#include "model/model.h"
#include "picture/camera.h"
#include "picture/image.h"
#include "picture/yarn_field.h"

namespace knitmech::picture {

/// How a fabric is drawn.
struct PictureOptions {
  int width = 0;      ///< [px]; 0: as the proportions of the fabric ask for
  int height = 1400;  ///< [px]
  View view = View::front;
  double turn = 0;  ///< by which the fabric is turned about y, its front towards the right [degrees]
  /// What fits into the picture, along axes_of(view, turn); empty: the frame. Give the same for every frame of a
  /// series.
  std::optional<Extent> extent{};
  Window window{};  ///< part of the fabric that is drawn; yarn that reaches beyond is cut off
  ColourBy colour_by = ColourBy::plain;
  /// Values at the ends of the colour bar, in the unit of the field; empty: those of the frame. Give the same for every
  /// frame of a series.
  std::optional<std::pair<double, double>> range{};
  std::string caption{};  ///< a line at the lower left, UTF-8; the scale bar stands beside it
  /// Shadow of the yarns on the backdrop, where the whole fabric lies before it: from the front and from the back.
  bool has_shadow_on_backdrop = true;
  int threads = 0;  ///< that draw; 0: as many as the processor has. The picture does not depend on it.
};

/// Draws the yarns of a frame as smooth, lit tubes in true proportions on a light backdrop, with a scale bar, and a
/// colour bar if the colours mean a quantity. Ray tracing by Embree on the processor; no display is needed.
///
/// The same input gives the same picture, bit by bit. Yarn with positions that are not finite is left out. Throws
/// InputError if the picture would be smaller than 100 or larger than 20000 px, if range or window is empty or not
/// finite, or if no yarn can be drawn.
[[nodiscard]] Image draw_fabric(const model::Model& model, const model::Frame& frame, const PictureOptions& options);

/// Width [px] of that picture: options.width, or what the proportions of the fabric, the colour bar and the caption ask
/// for. Throws like draw_fabric().
[[nodiscard]] int picture_width(const model::Model& model, const model::Frame& frame, const PictureOptions& options);

/// The same as a PNG file. Throws FileError with the path and the reason.
void write_fabric_picture(const std::filesystem::path& path, const model::Model& model, const model::Frame& frame,
                          const PictureOptions& options = {});

}  // namespace knitmech::picture
