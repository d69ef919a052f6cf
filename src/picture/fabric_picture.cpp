#include "picture/fabric_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "base/errors.h"
#include "model/yarn_curve.h"
#include "picture/colour_bar.h"
#include "picture/ray_tracer.h"
#include "picture/text.h"
#include "picture/ticks.h"

namespace knitmech::picture {
namespace {

constexpr std::uint32_t kBackdropColour = 0xf6f5f2;
constexpr double kScaleBarRoom = 5;  // least room for the scale bar, in font sizes
constexpr std::uint32_t kInk = 0x262626;
constexpr std::uint32_t kPlainYarn = 0x2f7fb5;
constexpr std::uint32_t kEdgeYarn = 0xe2a33c;  // of elements of another section than the first
constexpr std::array<std::uint32_t, 2> kCourseColours{0x2a78b0, 0xe2a33c};

/// Sizes that follow from the height of the picture [px].
struct PageLayout {
  int width = 0;
  int height = 0;
  Area fabric;
  Area colour_bar;
  Area foot;
};

void check(const PictureOptions& options) {
  constexpr int kSmallest = 100;
  constexpr int kLargest = 20000;
  const auto fits = [](int side) { return side >= kSmallest && side <= kLargest; };
  if (!fits(options.height) || (options.width != 0 && !fits(options.width))) {
    throw InputError(fmt::format("A picture of {} x {} px cannot be drawn; give sides from {} to {} px.", options.width,
                                 options.height, kSmallest, kLargest));
  }
  const Window& window = options.window;
  if (!(0 <= window.left && window.left < window.right && window.right <= 1 && 0 <= window.bottom &&
        window.bottom < window.top && window.top <= 1)) {
    throw InputError(fmt::format(
        "The window from {} to {} across and {} to {} upwards is not a part of the fabric; give shares from 0 to 1.",
        window.left, window.right, window.bottom, window.top));
  }
  if (options.range && !(std::isfinite(options.range->first) && std::isfinite(options.range->second) &&
                         options.range->first < options.range->second)) {
    throw InputError(fmt::format("The colours cannot span {} to {}; give two numbers, the lower one first.",
                                 options.range->first, options.range->second));
  }
}

bool is_whole(const Window& window) {
  return window.left == 0 && window.right == 1 && window.bottom == 0 && window.top == 1;
}

int font_size(int height) {
  return std::max(10, static_cast<int>(std::lround(height / 56.0)));
}

PageLayout lay_out(const PictureOptions& options, const Eigen::Vector3d& size, int bar_width, double foot_width,
                   int text_size) {
  const double margin = 2.0 * text_size;
  const double foot = 2.4 * text_size;
  PageLayout page;
  page.height = options.height;
  page.fabric.left = margin;
  page.fabric.top = margin;
  page.fabric.height = page.height - 2 * margin - foot;
  const double bar_space = bar_width > 0 ? bar_width + 1.5 * margin : 0;
  // Fabrics are not much wider than high; the limits keep the page sensible for a single yarn or a run that exploded.
  const double natural = std::clamp(page.fabric.height * size.x() / size.y(), 1.0, 3.0 * page.height);
  const double wanted = std::max(natural + 2 * margin + bar_space, foot_width + 2 * margin);
  page.width = options.width > 0 ? options.width : static_cast<int>(std::ceil(wanted));
  page.fabric.width = std::max(1.0, page.width - 2 * margin - bar_space);
  page.colour_bar = {page.width - bar_width - margin, margin + 0.18 * page.fabric.height,
                     static_cast<double>(bar_width), 0.64 * page.fabric.height};
  page.foot = {margin, page.height - margin - foot, page.width - 2 * margin, margin + foot};
  return page;
}

/// A bar of a round length with its length beside it, and the caption at the right.
void draw_foot(Image& image, const Area& area, const Camera& camera, const Font& font, const std::string& caption) {
  const Colour ink = from_srgb(kInk);
  const double room = std::max(0.2 * area.width, kScaleBarRoom * font.size());
  const double length = round_number_below(room / camera.pixels_per_mm());
  const int left = static_cast<int>(area.left);
  const int right = left + static_cast<int>(std::lround(length * camera.pixels_per_mm()));
  const int bottom = static_cast<int>(area.top + area.height - 1.6 * font.size());
  const int thickness = std::max(2, font.size() / 7);
  const int whisker = font.size() / 4;
  image.fill(left, bottom - thickness, right, bottom, ink);
  for (const int end : {left, right - thickness}) {
    image.fill(end, bottom - thickness - whisker, end + thickness, bottom + whisker, ink);
  }
  const double text_left = right + 0.6 * font.size();
  const std::string length_text = fmt::format("{:g} mm", length);
  const double baseline = bottom + 0.3 * font.size();
  font.draw(image, text_left, baseline, length_text, ink);
  font.draw(image, area.left + area.width, baseline, caption, ink, TextAnchor::end);
}

/// Room for the caption beside a scale bar with its length [px].
double foot_width(const PictureOptions& options, const Font& font) {
  return font.length(options.caption) + (kScaleBarRoom + 7) * font.size();
}

std::function<Colour(const TubeHit&)> yarn_colours(const model::Model& model, const TubeScene& scene,
                                                   const std::optional<YarnField>& field, ColourBy colour_by) {
  if (field) {
    return [&scene, &field](const TubeHit& hit) {
      const auto node = static_cast<std::size_t>(scene.pieces()[static_cast<std::size_t>(hit.piece)].node);
      const double value = std::lerp(field->values[node], field->values[node + 1], hit.parameter);
      return map_colour((value - field->lowest) / (field->highest - field->lowest));
    };
  }
  if (colour_by == ColourBy::course) {
    std::array<Colour, kCourseColours.size()> colours;
    std::transform(kCourseColours.begin(), kCourseColours.end(), colours.begin(), from_srgb);
    return [&scene, &model, colours](const TubeHit& hit) {
      const auto node = static_cast<std::size_t>(scene.pieces()[static_cast<std::size_t>(hit.piece)].node);
      return colours[static_cast<std::size_t>(model.course[node]) % colours.size()];
    };
  }
  return [&scene, &model, plain = from_srgb(kPlainYarn), edge = from_srgb(kEdgeYarn)](const TubeHit& hit) {
    const auto node = static_cast<std::size_t>(scene.pieces()[static_cast<std::size_t>(hit.piece)].node);
    return model.element_section[node] == 0 ? plain : edge;
  };
}

int thread_count(int wanted) {
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::vector<model::CurvePiece> drawn_curves(const model::Model& model, const model::Frame& frame) {
  std::vector<model::CurvePiece> pieces = model::yarn_curves(model, frame);
  if (pieces.empty()) {
    throw InputError(
        fmt::format("Frame {} has no yarn whose position is known, so there is nothing to draw.", frame.index));
  }
  return pieces;
}

Extent drawn_extent(const std::vector<model::CurvePiece>& pieces, const PictureOptions& options) {
  const Extent whole = options.extent ? *options.extent : extent_along(axes_of(options.view, options.turn), pieces);
  return part_of(whole, options.window);
}

PageLayout lay_out(const Extent& extent, const std::optional<YarnField>& field, const PictureOptions& options,
                   const Font& font) {
  return lay_out(options, extent.size(), field ? colour_bar_width(*field, font) : 0, foot_width(options, font),
                 font.size());
}

bool has_shadow(const PictureOptions& options) {
  return options.has_shadow_on_backdrop && (options.view == View::front || options.view == View::back);
}

}  // namespace

int picture_width(const model::Model& model, const model::Frame& frame, const PictureOptions& options) {
  check(options);
  const std::optional<YarnField> field = yarn_field(options.colour_by, model, frame, options.range);
  return lay_out(drawn_extent(drawn_curves(model, frame), options), field, options, Font(font_size(options.height)))
      .width;
}

Image draw_fabric(const model::Model& model, const model::Frame& frame, const PictureOptions& options) {
  check(options);
  const TubeScene scene(drawn_curves(model, frame));
  const std::optional<YarnField> field = yarn_field(options.colour_by, model, frame, options.range);
  const Font font(font_size(options.height));
  const Extent extent = drawn_extent(scene.pieces(), options);
  const PageLayout page = lay_out(extent, field, options, font);
  const Camera camera(axes_of(options.view, options.turn), extent, page.fabric);
  Image image(page.width, page.height, from_srgb(kBackdropColour));
  trace(image,
        {.scene = scene,
         .camera = camera,
         .extent = extent,
         .area = is_whole(options.window) ? Area{0, 0, 1.0 * page.width, 1.0 * page.height} : page.fabric,
         .has_shadow_on_backdrop = has_shadow(options),
         .yarn_colour = yarn_colours(model, scene, field, options.colour_by)},
        thread_count(options.threads));
  if (field) {
    draw_colour_bar(image, page.colour_bar, *field, font);
  }
  draw_foot(image, page.foot, camera, font, options.caption);
  return image;
}

void write_fabric_picture(const std::filesystem::path& path, const model::Model& model, const model::Frame& frame,
                          const PictureOptions& options) {
  write_png(path, draw_fabric(model, frame, options));
}

}  // namespace knitmech::picture
