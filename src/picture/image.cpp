#include "picture/image.h"

#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <stdexcept>

#include "results/atomic_file.h"

namespace knitmech::picture {
namespace {

constexpr int kLargestSide = 20000;  // [px]

}  // namespace

Image::Image(int width, int height, const Colour& background) : width_(width), height_(height) {
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide) {
    throw std::invalid_argument(
        fmt::format("A picture of {} x {} px is not possible; each side is 1 to {} px.", width, height, kLargestSide));
  }
  pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background);
}

void Image::blend(int column, int row, const Colour& colour, float share) {
  if (column >= 0 && column < width_ && row >= 0 && row < height_) {
    Colour& pixel = at(column, row);
    pixel += share * (colour - pixel);
  }
}

void Image::fill(int left, int top, int right, int bottom, const Colour& colour) {
  for (int row = std::max(0, top); row < std::min(height_, bottom); ++row) {
    for (int column = std::max(0, left); column < std::min(width_, right); ++column) {
      at(column, row) = colour;
    }
  }
}

std::vector<std::uint8_t> rgb_bytes(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
  for (int row = 0; row < image.height(); ++row) {
    for (int column = 0; column < image.width(); ++column) {
      for (const float channel : image.at(column, row)) {
        rgb.push_back(to_srgb_byte(channel));
      }
    }
  }
  return rgb;
}

std::string png_bytes(const Image& image) {
  const std::vector<std::uint8_t> rgb = rgb_bytes(image);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width());
  header.height = static_cast<png_uint_32>(image.height());
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(fmt::format("The picture could not be turned into PNG: {}.", header.message));
  }
  bytes.resize(size);
  return bytes;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  results::write_file_atomically(path, png_bytes(image));
}

}  // namespace knitmech::picture
