#pragma once

#include <memory>
#include <string>

#include "picture/image.h"

namespace knitmech::picture {

/// Which point of a text lies at the given x.
enum class TextAnchor { start, middle, end };

/// Draws text into an Image with the font DejaVu Sans, by FreeType.
class Font {
 public:
  /// size: height of the letters' design square [px]. Throws FileError if the font file cannot be read.
  explicit Font(int size);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
  Font(Font&&) = delete;
  Font& operator=(Font&&) = delete;

  [[nodiscard]] int size() const { return size_; }

  /// Length of a text in UTF-8 [px].
  [[nodiscard]] double length(const std::string& text) const;

  /// Draws a text in UTF-8 with its base line at y [px]. What lies outside the picture is cut off.
  void draw(Image& image, double x, double y, const std::string& text, const Colour& colour,
            TextAnchor anchor = TextAnchor::start) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
  int size_;
};

}  // namespace knitmech::picture
