#include "knit/clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/segment_distance.h"
#include "knit/constants.h"

namespace knitmech::knit {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Segments of one block share a bounding ball; the value affects speed alone.
constexpr std::size_t kBlockSegments = 8;

struct Block {
  std::size_t first = 0;  ///< first segment
  std::size_t end = 0;    ///< behind the last segment
  Vector3d middle;
  double radius = 0;
};

/// One ERC as straight pieces of equal arc length.
struct Polyline {
  std::vector<Vector3d> points;
  double piece_length = 0;  ///< [mm], along the true curve
  double erc_length = 0;
  std::vector<Block> blocks;
};

/// A copy of the ERC elsewhere in the fabric.
struct Image {
  int course = 0;
  int wale = 0;
  int side = 1;  ///< -1: the mirror image
  double shift_x = 0;
  double shift_y = 0;

  [[nodiscard]] Vector3d of(const Vector3d& point) const {
    return {side * point.x() + shift_x, point.y() + shift_y, point.z()};
  }
};

/// The closest pair of segments found so far.
struct Candidate {
  double distance = kInfinity;
  double arc_a = 0;  ///< [mm], from the head middle of the ERC
  double arc_b = 0;
  Vector3d point = Vector3d::Zero();
  Image image;
};

Vector3 plain(const Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Block make_block(const std::vector<Vector3d>& points, std::size_t first, std::size_t end) {
  Block block{.first = first, .end = end, .middle = Vector3d::Zero(), .radius = 0};
  for (std::size_t i = first; i <= end; ++i) block.middle += points[i] / static_cast<double>(end - first + 1);
  for (std::size_t i = first; i <= end; ++i) block.radius = std::max(block.radius, (points[i] - block.middle).norm());
  return block;
}

Polyline make_polyline(const Erc& erc, int n_pieces) {
  Polyline line;
  for (const CurvePoint& at : equal_arc_points(erc, n_pieces)) line.points.push_back(at.position);
  line.piece_length = erc.length / n_pieces;
  line.erc_length = erc.length;
  const std::size_t n_segments = line.points.size() - 1;
  for (std::size_t first = 0; first < n_segments; first += kBlockSegments) {
    line.blocks.push_back(make_block(line.points, first, std::min(first + kBlockSegments, n_segments)));
  }
  return line;
}

/// The search for the closest pair between the ERC and its images. Points of one yarn count only if the yarn comes back
/// between them, see kSelfContactArc.
class Search {
 public:
  Search(const Polyline& line, double diameter) : line_(line), diameter_(diameter) {}

  void add(const Image& image) {
    for (const Block& a : line_.blocks) {
      for (const Block& b : line_.blocks) {
        const double between_middles = (a.middle - image.of(b.middle)).norm();
        if (between_middles - a.radius - b.radius < best_.distance) compare_blocks(a, b, image);
      }
    }
  }

  [[nodiscard]] const Candidate& best() const { return best_; }

 private:
  void compare_blocks(const Block& a, const Block& b, const Image& image) {
    for (std::size_t i = a.first; i < a.end; ++i) {
      for (std::size_t j = b.first; j < b.end; ++j) compare_segments(i, j, image);
    }
  }

  void compare_segments(std::size_t i, std::size_t j, const Image& image) {
    const Vector3d& a = line_.points[i];
    const Vector3d u = line_.points[i + 1] - a;
    const Vector3d b = image.of(line_.points[j]);
    const Vector3d v = image.of(line_.points[j + 1]) - b;
    const ClosestPoints at = closest_points(plain(a), plain(u), plain(b), plain(v));
    const Vector3d on_a = a + at.s * u;
    const Vector3d on_b = b + at.t * v;
    const double distance = (on_b - on_a).norm();
    if (distance >= best_.distance) return;
    const double arc_a = (static_cast<double>(i) + at.s) * line_.piece_length;
    const double arc_b = (static_cast<double>(j) + at.t) * line_.piece_length;
    const double facing_arc = kSelfContactArc * std::max(distance, diameter_);
    if (image.course == 0 && arc_between(arc_a, arc_b, image) < facing_arc) return;
    best_ = {.distance = distance, .arc_a = arc_a, .arc_b = arc_b, .point = 0.5 * (on_a + on_b), .image = image};
  }

  [[nodiscard]] double arc_between(double arc_a, double arc_b, const Image& image) const {
    return std::abs(2 * line_.erc_length * image.wale + image.side * arc_b - arc_a);
  }

  const Polyline& line_;
  double diameter_;
  Candidate best_;
};

Neighbours neighbours_of(const Image& image) {
  if (image.course > 1) return Neighbours::further_course;
  if (image.course == 1) return Neighbours::next_course;
  return image.wale == 0 ? Neighbours::same_loop : Neighbours::next_wale;
}

/// The copies of the ERC that a fabric of this size has around one of its stitches, nearest first.
std::vector<Image> images_around(const FabricLayout& layout, double diameter) {
  std::vector<Image> images;
  const double reach = layout.loop.height + diameter;
  for (int course = 0; course < layout.courses && course * layout.course_spacing < reach; ++course) {
    for (const int wale : {0, 1, -1}) {
      if (wale != 0 && layout.wales == 1) continue;
      for (const int side : {1, -1}) {
        images.push_back({.course = course,
                          .wale = wale,
                          .side = side,
                          .shift_x = wale * layout.loop.width,
                          .shift_y = course * layout.course_spacing});
      }
    }
  }
  return images;
}

Approach approach_from(const Candidate& found, const Erc& erc, const FabricLayout& layout, double diameter) {
  const int first_wale = std::max(0, -found.image.wale);
  Approach approach;
  approach.neighbours = neighbours_of(found.image);
  approach.gap = found.distance - diameter;
  approach.a = {.course = 0, .wale = first_wale, .piece = piece_at_arc_length(erc, found.arc_a)};
  approach.b = {.course = found.image.course,
                .wale = first_wale + found.image.wale,
                .piece = piece_at_arc_length(erc, found.arc_b)};
  approach.point = found.point;
  approach.point.x() += first_wale * layout.loop.width;
  return approach;
}

}  // namespace

std::vector<Approach> closest_approaches(const Erc& erc, const FabricLayout& layout, double diameter,
                                         int pieces_per_erc, std::span<const Neighbours> wanted) {
  const Polyline line = make_polyline(erc, pieces_per_erc);
  const std::vector<Image> images = images_around(layout, diameter);
  std::vector<Approach> approaches;
  for (const Neighbours kind : wanted) {
    Search search(line, diameter);
    for (const Image& image : images) {
      if (neighbours_of(image) == kind) search.add(image);
    }
    if (search.best().distance < kInfinity) {
      approaches.push_back(approach_from(search.best(), erc, layout, diameter));
    }
  }
  return approaches;
}

std::optional<Approach> least_gap(const std::vector<Approach>& approaches) {
  const auto least = std::min_element(approaches.begin(), approaches.end(),
                                      [](const Approach& a, const Approach& b) { return a.gap < b.gap; });
  if (least == approaches.end()) return std::nullopt;
  return *least;
}

std::string describe(const Place& place) {
  constexpr std::array<const char*, kErcPieces> names = {"head", "head arc", "leg", "foot arc", "foot"};
  return fmt::format("the {} of course {}, wale {}", names[static_cast<std::size_t>(place.piece)], place.course + 1,
                     place.wale + 1);
}

}  // namespace knitmech::knit
