#include "picture/svg.h"

#include <fmt/core.h>

#include "base/text.h"

namespace knitmech::picture {
namespace {

constexpr const char* kFont = "DejaVu Sans, Helvetica, Arial, sans-serif";

}  // namespace

std::string text_element(double x, double y, double size, const char* anchor, const std::string& text,
                         const std::string& more) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, size,
                     anchor, more, base::in_markup(text));
}

std::string line_element(double x1, double y1, double x2, double y2, const char* attributes) {
  return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", x1, y1, x2, y2,
                     attributes);
}

std::string svg_document(int width, int height, const std::string& elements) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"{2}\" fill=\"#222222\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{3}</svg>\n",
      width, height, kFont, elements);
}

}  // namespace knitmech::picture
