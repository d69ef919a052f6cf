#include "picture/text.h"

#include <fmt/core.h>
#include <ft2build.h>

#include <cmath>
#include <cstdint>
#include <string_view>
#include FT_FREETYPE_H

#include "base/errors.h"
#include "base/text.h"

namespace knitmech::picture {
namespace {

constexpr double kFixedPoint = 64;  // FreeType counts in 1/64 px

}  // namespace

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Face() = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  Face(Face&&) = delete;
  Face& operator=(Face&&) = delete;
  ~Face() {
    if (library != nullptr) {
      FT_Done_FreeType(library);  // frees its faces as well
    }
  }

  [[nodiscard]] bool load(char32_t letter) const { return FT_Load_Char(face, letter, FT_LOAD_RENDER) == 0; }
};

Font::Font(int size) : face_(std::make_unique<Face>()), size_(size) {
  if (FT_Init_FreeType(&face_->library) != 0 || FT_New_Face(face_->library, KNITMECH_FONT, 0, &face_->face) != 0 ||
      FT_Set_Pixel_Sizes(face_->face, 0, static_cast<FT_UInt>(size)) != 0) {
    throw FileError(fmt::format("Cannot read the font \"{}\", in which numbers are drawn.", KNITMECH_FONT));
  }
}

Font::~Font() = default;

double Font::length(const std::string& text) const {
  double length = 0;
  for (std::string_view rest = text; !rest.empty();) {
    if (face_->load(base::take_letter(rest))) {
      length += static_cast<double>(face_->face->glyph->advance.x) / kFixedPoint;
    }
  }
  return length;
}

void Font::draw(Image& image, double x, double y, const std::string& text, const Colour& colour,
                TextAnchor anchor) const {
  if (anchor != TextAnchor::start) {
    x -= length(text) * (anchor == TextAnchor::middle ? 0.5 : 1.0);
  }
  const int baseline = static_cast<int>(std::lround(y));
  for (std::string_view rest = text; !rest.empty();) {
    if (!face_->load(base::take_letter(rest))) {
      continue;
    }
    const FT_GlyphSlotRec_* const glyph = face_->face->glyph;
    const int left = static_cast<int>(std::lround(x)) + glyph->bitmap_left;
    for (int row = 0; row < static_cast<int>(glyph->bitmap.rows); ++row) {
      const unsigned char* line = glyph->bitmap.buffer + static_cast<std::ptrdiff_t>(row) * glyph->bitmap.pitch;
      for (int column = 0; column < static_cast<int>(glyph->bitmap.width); ++column) {
        image.blend(left + column, baseline - glyph->bitmap_top + row, colour,
                    static_cast<float>(line[column]) / 255.0F);
      }
    }
    x += static_cast<double>(glyph->advance.x) / kFixedPoint;
  }
}

}  // namespace knitmech::picture
