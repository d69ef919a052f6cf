#include "contact/neighbour_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/blocks.h"
#include "base/segment_distance.h"
#include "contact/constants.h"

namespace knitmech::contact {

namespace {

Vector3 middle_of(const model::VectorArray& position, std::size_t element) {
  return 0.5 * (position.at(element) + position.at(element + 1));
}

/// A cell of the grid, by its place in x, y and z.
using Cell = std::array<std::int64_t, 3>;

/// The elements by the cell of a uniform grid that their middle lies in. Cells have no table of their own, which would
/// be huge for a fabric that curls, or of which a yarn hangs far out: they are folded into as many buckets as there are
/// elements, cells that follow each other along x into buckets that do.
class Grid {
 public:
  Grid(const ContactElements& elements, const model::VectorArray& position, double reach) : position_(position) {
    std::size_t n_elements = 0;
    double longest = 0;
    for (std::size_t i = 0; i < elements.n_nodes(); ++i) {
      if (elements.exists[i] == 0) continue;
      longest = std::max(longest, length(position.at(i + 1) - position.at(i)));
      ++n_elements;
    }
    cell_ = longest + reach;
    const std::size_t n_buckets = std::bit_ceil(std::max(n_elements, kAlongX));
    mask_ = n_buckets - 1;
    sort_into_buckets(elements, n_elements);
  }

  /// Calls for every other element whose middle lies in the cell of this one's or in an adjacent one.
  template <typename Call>
  void around(std::size_t element, const Call& call) const {
    const Cell home = cell_of(element);
    for (std::int64_t z = home[2] - 1; z <= home[2] + 1; ++z) {
      for (std::int64_t y = home[1] - 1; y <= home[1] + 1; ++y) {
        for (std::int64_t x = home[0] - 1; x <= home[0] + 1; ++x) {
          const std::size_t bucket = bucket_of({x, y, z});
          for (std::int32_t m = start_[bucket]; m < start_[bucket + 1]; ++m) {
            const auto other = static_cast<std::size_t>(members_[static_cast<std::size_t>(m)]);
            if (other != element && cell_of(other) == Cell{x, y, z}) call(other);
          }
        }
      }
    }
  }

 private:
  static constexpr std::size_t kAlongX = 4;  ///< so that adjacent cells along x are different buckets

  [[nodiscard]] Cell cell_of(std::size_t element) const {
    const Vector3 p = (1 / cell_) * middle_of(position_, element);
    return {static_cast<std::int64_t>(std::floor(p.x)), static_cast<std::int64_t>(std::floor(p.y)),
            static_cast<std::int64_t>(std::floor(p.z))};
  }

  /// The factors spread rows of cells over the buckets (Teschner et al. 2003, "Optimized spatial hashing").
  [[nodiscard]] std::size_t bucket_of(const Cell& cell) const {
    const auto y = static_cast<std::uint64_t>(cell[1]) * 19349663U;
    const auto z = static_cast<std::uint64_t>(cell[2]) * 83492791U;
    return static_cast<std::size_t>(((y ^ z) + static_cast<std::uint64_t>(cell[0])) & mask_);
  }

  void sort_into_buckets(const ContactElements& elements, std::size_t n_elements) {
    start_.assign(mask_ + 2, 0);
    for (std::size_t i = 0; i < elements.n_nodes(); ++i) {
      if (elements.exists[i] != 0) ++start_[bucket_of(cell_of(i)) + 1];
    }
    for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
    members_.resize(n_elements);
    // Backwards, from the end of each bucket, after which the ends have become the starts.
    for (std::size_t i = elements.n_nodes(); i-- > 0;) {
      if (elements.exists[i] == 0) continue;
      std::int32_t& end = start_[bucket_of(cell_of(i)) + 1];
      members_[static_cast<std::size_t>(--end)] = static_cast<std::int32_t>(i);
    }
    std::rotate(start_.begin(), start_.begin() + 1, start_.end());
    start_.back() = static_cast<std::int32_t>(n_elements);
  }

  const model::VectorArray& position_;
  double cell_ = 0;                    ///< edge length [mm]
  std::uint64_t mask_ = 0;             ///< number of buckets, a power of two, minus 1
  std::vector<std::int32_t> start_;    ///< first entry of `members_` of each bucket, and the end
  std::vector<std::int32_t> members_;  ///< elements, bucket by bucket
};

/// Distance of two elements' chords against a reach [mm], with a cheap look at the middles first.
bool within_reach(const model::VectorArray& position, std::size_t a, std::size_t b, double reach) {
  const Vector3 u = position.at(a + 1) - position.at(a);
  const Vector3 v = position.at(b + 1) - position.at(b);
  const double far = reach + 0.5 * (length(u) + length(v));
  const Vector3 between = middle_of(position, b) - middle_of(position, a);
  if (dot(between, between) > far * far) return false;
  const ClosestPoints at = closest_points(position.at(a), u, position.at(b), v);
  const Vector3 gap = position.at(b) + at.t * v - position.at(a) - at.s * u;
  return dot(gap, gap) < reach * reach;
}

}  // namespace

bool too_near_along_yarn(const ContactElements& elements, std::size_t first, std::size_t second) {
  if (elements.yarn[first] != elements.yarn[second]) return false;
  if (second <= first + 1) return true;
  const double diameter = elements.radius_of(first) + elements.radius_of(second);
  return elements.arc_length[second] - elements.arc_length[first + 1] < kSelfContactArc * std::numbers::pi * diameter;
}

std::vector<ElementPair> find_neighbours(const ContactElements& elements, const model::VectorArray& position,
                                         const std::vector<double>& bulge, double skin, const std::vector<char>& is_due,
                                         SearchCost* cost, const base::ThreadTeam& team) {
  const double largest_bulge = *std::max_element(bulge.begin(), bulge.end());
  const Grid grid(elements, position, 2 * elements.largest_radius + skin + 2 * largest_bulge);
  const auto m = static_cast<std::size_t>(elements.pieces_per_element);
  const auto bulge_of = [&](std::size_t piece) { return bulge[piece / m]; };
  const auto due = [&](std::size_t element) { return is_due.empty() || is_due[element] != 0; };
  const auto search = [&](std::size_t a, std::vector<ElementPair>& pairs, std::int64_t& compared) {
    grid.around(a, [&](std::size_t b) {
      if (b < a && due(b)) return;  // found from there
      ++compared;
      const auto [first, second] = std::minmax(a, b);
      if (too_near_along_yarn(elements, first, second)) return;
      const double reach = elements.radius_of(a) + elements.radius_of(b) + skin + bulge_of(a) + bulge_of(b);
      if (!within_reach(position, first, second, reach)) return;
      pairs.push_back({static_cast<std::int32_t>(first), static_cast<std::int32_t>(second)});
    });
  };
  std::vector<std::vector<ElementPair>> found(team.size());
  std::vector<std::int64_t> compared(team.size(), 0);
  team.run([&](std::size_t part) {
    const auto range = team.range_of(part, elements.n_nodes(), base::kBlock);
    for (std::size_t a = range.begin; a < range.end; ++a) {
      if (elements.exists[a] != 0 && due(a)) search(a, found[part], compared[part]);
    }
  });
  std::vector<ElementPair> pairs = std::move(found.front());
  for (std::size_t part = 1; part < found.size(); ++part) {
    pairs.insert(pairs.end(), found[part].begin(), found[part].end());
  }
  std::sort(pairs.begin(), pairs.end());
  if (cost != nullptr) cost->compared = std::accumulate(compared.begin(), compared.end(), std::int64_t{0});
  return pairs;
}

}  // namespace knitmech::contact
