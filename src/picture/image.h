#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "picture/colour.h"

namespace knitmech::picture {

/// A picture in linear light, row by row from the top.
class Image {
 public:
  /// Throws std::invalid_argument unless both sides are between 1 and 20000 px.
  Image(int width, int height, const Colour& background);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Colour& at(int column, int row) { return pixels_[index(column, row)]; }
  [[nodiscard]] const Colour& at(int column, int row) const { return pixels_[index(column, row)]; }

  /// Lays a colour over a pixel: share 0 leaves it, 1 replaces it. Pixels outside the picture are ignored.
  void blend(int column, int row, const Colour& colour, float share);

  /// Fills the part of a rectangle [px] that lies inside the picture; right and bottom are exclusive.
  void fill(int left, int top, int right, int bottom, const Colour& colour);

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }

  int width_;
  int height_;
  std::vector<Colour> pixels_;
};

/// The picture as 8 bits a channel, sRGB: red, green and blue of each pixel, row by row from the top.
[[nodiscard]] std::vector<std::uint8_t> rgb_bytes(const Image& image);

/// The bytes of a PNG file: 8 bits a channel, sRGB, no transparency, no date, so that equal pictures give equal bytes.
[[nodiscard]] std::string png_bytes(const Image& image);

/// Writes a PNG file. Throws FileError with the path and the reason.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace knitmech::picture
