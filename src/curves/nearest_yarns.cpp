#include "curves/nearest_yarns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/segment_distance.h"
#include "curves/constants.h"

namespace knitmech::curves {
namespace {

struct Piece {
  Vector3 start, along;  ///< [mm]
  double length = 0;     ///< [mm]
  PlaceOnLine place;     ///< of its start
};

Vector3 vector_of(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

std::vector<Piece> pieces_of(const std::vector<std::vector<Eigen::Vector3d>>& yarns) {
  std::vector<Piece> pieces;
  for (std::size_t yarn = 0; yarn < yarns.size(); ++yarn) {
    double arc_length = 0;
    for (std::size_t i = 0; i + 1 < yarns[yarn].size(); ++i) {
      const Eigen::Vector3d along = yarns[yarn][i + 1] - yarns[yarn][i];
      pieces.push_back({vector_of(yarns[yarn][i]), vector_of(along), along.norm(), {yarn, arc_length}});
      arc_length += along.norm();
    }
  }
  return pieces;
}

/// A cell of space by its three numbers.
using Cell = std::array<std::int64_t, 3>;

/// A cell and a piece whose middle lies in it.
using Entry = std::pair<Cell, std::uint32_t>;

/// Pieces by the cell of their middle.
class Cells {
 public:
  Cells(const std::vector<Piece>& pieces, double size) : size_(size) {
    for (std::uint32_t i = 0; i < pieces.size(); ++i) entries_.emplace_back(cell_of(pieces[i]), i);
    std::ranges::sort(entries_);
  }

  /// Calls look(i, j) with i < j for all pieces in the same cell or in cells side by side.
  template <class Look>
  void for_each_pair(const Look& look) const {
    for (const Entry& entry : entries_) {
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
          // Cells that differ in their last number alone follow each other.
          const Cell first = {entry.first[0] + dx, entry.first[1] + dy, entry.first[2] - 1};
          const Cell last = {first[0], first[1], entry.first[2] + 1};
          for (auto other = std::ranges::lower_bound(entries_, Entry{first, 0});
               other != entries_.end() && other->first <= last; ++other) {
            if (entry.second < other->second) look(entry.second, other->second);
          }
        }
      }
    }
  }

 private:
  [[nodiscard]] Cell cell_of(const Piece& piece) const {
    const Vector3 middle = piece.start + 0.5 * piece.along;
    const auto number = [this](double value) { return static_cast<std::int64_t>(std::floor(value / size_)); };
    return {number(middle.x), number(middle.y), number(middle.z)};
  }

  double size_;
  std::vector<Entry> entries_;
};

}  // namespace

std::optional<NearestYarns> nearest_yarns(const std::vector<std::vector<Eigen::Vector3d>>& yarns, double diameter,
                                          double reach) {
  const std::vector<Piece> pieces = pieces_of(yarns);
  double longest = 0;
  for (const Piece& piece : pieces) longest = std::max(longest, piece.length);
  std::optional<NearestYarns> nearest;
  double least = reach;
  const Cells cells(pieces, reach + longest);
  cells.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    const Piece& a = pieces[i];
    const Piece& b = pieces[j];
    const ClosestPoints closest = closest_points(a.start, a.along, b.start, b.along);
    const Vector3 on_a = a.start + closest.s * a.along;
    const Vector3 on_b = b.start + closest.t * b.along;
    const double distance = length(on_b - on_a);
    if (distance >= least) return;
    const PlaceOnLine place_a{a.place.yarn, a.place.arc_length + closest.s * a.length};
    const PlaceOnLine place_b{b.place.yarn, b.place.arc_length + closest.t * b.length};
    const double between = place_b.arc_length - place_a.arc_length;
    if (place_a.yarn == place_b.yarn && between < kComesBack * std::max(distance, diameter)) return;
    least = distance;
    const Vector3 middle = 0.5 * (on_a + on_b);
    nearest = NearestYarns{distance, place_a, place_b, {middle.x, middle.y, middle.z}};
  });
  return nearest;
}

}  // namespace knitmech::curves
