#include "report/frame_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/errors.h"
#include "base/number_text.h"
#include "picture/fabric_picture.h"
#include "picture/image.h"

namespace knitmech::report {
namespace {

struct Colouring {
  picture::ColourBy colour_by;
  const char* name;
  const char* title;
};
constexpr std::array<Colouring, 4> kColourings = {{{picture::ColourBy::contact_force, "contact-force", "Contact force"},
                                                   {picture::ColourBy::curvature, "curvature", "Curvature"},
                                                   {picture::ColourBy::axial_force, "axial-force", "Axial force"},
                                                   {picture::ColourBy::out_of_plane, "out-of-plane", "Out of plane"}}};

using Range = std::pair<double, double>;

/// The range that holds the values of all frames.
std::optional<Range> common_range(picture::ColourBy colour_by, const model::Model& model,
                                  const std::vector<model::Frame>& frames) {
  std::optional<Range> range;
  for (const model::Frame& frame : frames) {
    const auto field = picture::yarn_field(colour_by, model, frame, std::nullopt);
    if (!field) continue;
    if (!range) range = {field->lowest, field->highest};
    range = {std::min(range->first, field->lowest), std::max(range->second, field->highest)};
  }
  return range;
}

/// A picture as PNG; empty if no yarn can be drawn, because a run has failed and its yarns are scattered.
std::string draw(const model::Model& model, const model::Frame& frame, picture::PictureOptions options) {
  options.caption = base::percent_text(frame.history.strain);
  try {
    return picture::png_bytes(picture::draw_fabric(model, frame, options));
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

std::vector<PictureRow> draw_rows(const model::Model& model, const std::vector<model::Frame>& frames, int height,
                                  int threads) {
  std::vector<PictureRow> rows;
  for (const Colouring& colouring : kColourings) {
    PictureRow row{colouring.name, colouring.title, {}};
    picture::PictureOptions options;
    options.height = height;
    options.threads = threads;
    options.colour_by = colouring.colour_by;
    options.range = common_range(colouring.colour_by, model, frames);
    for (const model::Frame& frame : frames) row.png.push_back(draw(model, frame, options));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string draw_contact(const model::Model& model, const model::Frame& frame, int height, int threads) {
  picture::PictureOptions options;
  options.height = height;
  options.threads = threads;
  options.colour_by = picture::ColourBy::contact_force;
  return draw(model, frame, options);
}

}  // namespace knitmech::report
