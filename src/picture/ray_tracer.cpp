#include "picture/ray_tracer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "picture/constants.h"
#include "picture/sampling.h"
#include "picture/shading.h"

namespace knitmech::picture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Calls work(row) for every row, shared among threads.
template <typename Work>
void for_each_row(int rows, int threads, const Work& work) {
  std::atomic<int> next{0};
  const auto take_rows = [&] {
    for (int row = next++; row < rows; row = next++) {
      work(row);
    }
  };
  std::vector<std::jthread> team;
  for (int i = 1; i < threads; ++i) {
    team.emplace_back(take_rows);
  }
  take_rows();
}

/// The pixels of an area, cut off at the edges of the picture; right and bottom are exclusive.
struct PixelRange {
  int left, top, right, bottom;

  PixelRange(const Image& image, const Area& area)
      : left(std::max(0, static_cast<int>(std::lround(area.left)))),
        top(std::max(0, static_cast<int>(std::lround(area.top)))),
        right(std::min(image.width(), static_cast<int>(std::lround(area.left + area.width)))),
        bottom(std::min(image.height(), static_cast<int>(std::lround(area.top + area.height)))) {}
};

/// Marks the pixels that a yarn may cover, so that rays are spent on them only.
class CoveredPixels {
 public:
  CoveredPixels(const Image& image, const Drawing& drawing)
      : width_(image.width()),
        height_(image.height()),
        covered_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {
    for (const model::CurvePiece& piece : drawing.scene.pieces()) {
      for (int k = 0; k < kStraightPiecesPerElement; ++k) {
        const double u = static_cast<double>(k) / kStraightPiecesPerElement;
        const Vector2d a = drawing.camera.place_of(piece.point(u));
        const Vector2d b = drawing.camera.place_of(piece.point(u + 1.0 / kStraightPiecesPerElement));
        mark(a, b, piece.radius * drawing.camera.pixels_per_mm() + 1);
      }
    }
  }

  [[nodiscard]] bool contains(int column, int row) const {
    return covered_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(column)] != 0;
  }

 private:
  void mark(const Vector2d& a, const Vector2d& b, double margin) {
    const int left = std::max(0, static_cast<int>(std::floor(std::min(a.x(), b.x()) - margin)));
    const int right = std::min(width_ - 1, static_cast<int>(std::floor(std::max(a.x(), b.x()) + margin)));
    const int top = std::max(0, static_cast<int>(std::floor(std::min(a.y(), b.y()) - margin)));
    const int bottom = std::min(height_ - 1, static_cast<int>(std::floor(std::max(a.y(), b.y()) + margin)));
    for (int row = top; row <= bottom && left <= right; ++row) {
      const auto begin = covered_.begin() + static_cast<std::ptrdiff_t>(row) * width_ + left;
      std::fill(begin, begin + (right - left + 1), char{1});
    }
  }

  int width_;
  int height_;
  std::vector<char> covered_;
};

/// The light that reaches the backdrop, on a coarse grid that is interpolated.
class BackdropLight {
 public:
  BackdropLight(const Image& image, const Drawing& drawing, const Lighting& lighting, double depth, int threads)
      : columns_(image.width() / kShadowGrid + 2),
        rows_(image.height() / kShadowGrid + 2),
        light_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 1.0F) {
    for_each_row(rows_, threads, [&](int row) {
      for (int column = 0; column < columns_; ++column) {
        const Vector3d point = drawing.camera.point_at(column * kShadowGrid, row * kShadowGrid, depth);
        light_[index(column, row)] = static_cast<float>(lighting.on_backdrop(drawing.scene, point));
      }
    });
  }

  [[nodiscard]] float at(double x, double y) const {
    const double u = std::max(0.0, x / kShadowGrid);
    const double v = std::max(0.0, y / kShadowGrid);
    const int column = std::min(static_cast<int>(u), columns_ - 2);
    const int row = std::min(static_cast<int>(v), rows_ - 2);
    const auto across = static_cast<float>(u - column);
    const auto down = static_cast<float>(v - row);
    const float upper = std::lerp(light_[index(column, row)], light_[index(column + 1, row)], across);
    const float lower = std::lerp(light_[index(column, row + 1)], light_[index(column + 1, row + 1)], across);
    return std::lerp(upper, lower, down);
  }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  int columns_;
  int rows_;
  std::vector<float> light_;
};

double largest_diameter(const TubeScene& scene) {
  double diameter = 0;
  for (const model::CurvePiece& piece : scene.pieces()) {
    diameter = std::max(diameter, 2 * piece.radius);
  }
  return diameter;
}

/// Mean colour over the rays of one pixel.
Colour pixel_colour(const Drawing& drawing, const Lighting& lighting, double start_depth, const Colour& backdrop,
                    int column, int row, std::uint64_t seed) {
  Randomness random(seed);
  Colour sum = Colour::Zero();
  for (int i = 0; i < kRaysPerPixelSide * kRaysPerPixelSide; ++i) {
    const double x = column + (i % kRaysPerPixelSide + random.next()) / kRaysPerPixelSide;
    const double y =
        row + (i / kRaysPerPixelSide + random.next()) / kRaysPerPixelSide;  // NOLINT(bugprone-integer-division)
    const Vector3d origin = drawing.camera.point_at(x, y, start_depth);
    const auto hit = drawing.scene.first_hit(origin, -drawing.camera.axes().towards_viewer);
    // A highlight brighter than white would make the edge towards it hard, so each ray is cut off by itself.
    sum += hit ? Colour(lighting.of_yarn(drawing.scene, *hit, drawing.yarn_colour(*hit), random).cwiseMin(1.0F))
               : backdrop;
  }
  return sum / static_cast<float>(kRaysPerPixelSide * kRaysPerPixelSide);
}

}  // namespace

void trace(Image& image, const Drawing& drawing, int threads) {
  const double diameter = largest_diameter(drawing.scene);
  const Lighting lighting(drawing.camera.axes());
  const CoveredPixels covered(image, drawing);
  const PixelRange pixels(image, drawing.area);
  const double start_depth = drawing.extent.highest.z() + diameter;
  if (drawing.has_shadow_on_backdrop) {
    const double backdrop_depth = drawing.extent.lowest.z() - kBackdropDistance * diameter;
    const BackdropLight light(image, drawing, lighting, backdrop_depth, threads);
    for (int row = pixels.top; row < pixels.bottom; ++row) {
      for (int column = pixels.left; column < pixels.right; ++column) {
        image.at(column, row) *= light.at(column + 0.5, row + 0.5);
      }
    }
  }
  for_each_row(pixels.bottom - pixels.top, threads, [&](int index) {
    const int row = pixels.top + index;
    for (int column = pixels.left; column < pixels.right; ++column) {
      if (covered.contains(column, row)) {
        const auto seed = static_cast<std::uint64_t>(row) * static_cast<std::uint64_t>(image.width()) +
                          static_cast<std::uint64_t>(column);
        Colour& pixel = image.at(column, row);
        pixel = pixel_colour(drawing, lighting, start_depth, pixel, column, row, seed);
      }
    }
  });
}

}  // namespace knitmech::picture
