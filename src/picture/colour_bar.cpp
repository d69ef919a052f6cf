#include "picture/colour_bar.h"

#include <algorithm>
#include <cmath>

#include "picture/ticks.h"

namespace knitmech::picture {
namespace {

constexpr std::uint32_t kInk = 0x262626;

int bar_width(const Font& font) {
  return font.size();
}
int number_offset(const Font& font) {
  return bar_width(font) + font.size() / 2;
}

}  // namespace

int colour_bar_width(const YarnField& field, const Font& font) {
  double widest = font.length(field.label);
  for (const std::string& label : nice_ticks(field.lowest, field.highest, kColourBarIntervals).labels) {
    widest = std::max(widest, number_offset(font) + font.length(label));
  }
  return static_cast<int>(std::ceil(widest));
}

void draw_colour_bar(Image& image, const Area& area, const YarnField& field, const Font& font) {
  const Colour ink = from_srgb(kInk);
  const int left = static_cast<int>(area.left);
  const int label_height = 2 * font.size();
  const int top = static_cast<int>(area.top) + label_height;
  const int bottom = static_cast<int>(area.top + area.height) - font.size() / 2;
  font.draw(image, left, area.top + font.size(), field.label, ink);
  for (int row = top; row < bottom; ++row) {
    const double value = 1 - (row + 0.5 - top) / (bottom - top);
    image.fill(left, row, left + bar_width(font), row + 1, map_colour(value));
  }
  const Ticks ticks = nice_ticks(field.lowest, field.highest, kColourBarIntervals);
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const double share = (ticks.values[i] - field.lowest) / (field.highest - field.lowest);
    if (share < -1e-9 || share > 1 + 1e-9) {
      continue;
    }
    const int row = static_cast<int>(std::lround(bottom - share * (bottom - top)));
    image.fill(left + bar_width(font), row - 1, left + bar_width(font) + font.size() / 4, row + 1, ink);
    font.draw(image, left + number_offset(font), row + 0.36 * font.size(), ticks.labels[i], ink);
  }
}

}  // namespace knitmech::picture
