#include "contact/neighbour_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/segment_distance.h"
#include "contact/constants.h"

namespace knitmech::contact {

namespace {

/// Element middles and the uniform grid over them.
struct Grid {
  std::vector<Vector3> middle;             ///< [mm], one entry per node
  Vector3 origin{};                        ///< [mm]
  double cell = 0;                         ///< edge length [mm]
  std::array<std::int64_t, 3> n{1, 1, 1};  ///< cells along x, y, z
  std::vector<std::int32_t> start;         ///< first entry of `members` of each cell, and the end
  std::vector<std::int32_t> members;       ///< elements, cell by cell

  [[nodiscard]] std::array<std::int64_t, 3> cell_of(Vector3 p) const {
    return {static_cast<std::int64_t>((p.x - origin.x) / cell), static_cast<std::int64_t>((p.y - origin.y) / cell),
            static_cast<std::int64_t>((p.z - origin.z) / cell)};
  }
  [[nodiscard]] std::size_t index(const std::array<std::int64_t, 3>& c) const {
    return static_cast<std::size_t>((c[2] * n[1] + c[1]) * n[0] + c[0]);
  }
};

struct Box {
  Vector3 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
              std::numeric_limits<double>::max()};
  Vector3 high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(),
               std::numeric_limits<double>::lowest()};
  void add(Vector3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

/// Cells at least as long as the reach of an element, and not many more of them than elements.
void choose_cells(Grid& grid, const Box& box, double reach, std::size_t n_elements) {
  grid.origin = box.low;
  grid.cell = reach;
  const Vector3 size = box.high - box.low;
  const double most_cells = 8.0 * static_cast<double>(n_elements) + 64;
  for (;;) {
    const double nx = std::floor(size.x / grid.cell) + 1;
    const double ny = std::floor(size.y / grid.cell) + 1;
    const double nz = std::floor(size.z / grid.cell) + 1;
    if (nx * ny * nz <= most_cells) {
      grid.n = {static_cast<std::int64_t>(nx), static_cast<std::int64_t>(ny), static_cast<std::int64_t>(nz)};
      return;
    }
    grid.cell *= 1.25;
  }
}

Grid make_grid(const ContactElements& elements, const model::VectorArray& position, double reach) {
  Grid grid;
  grid.middle.resize(elements.n_nodes());
  Box box;
  double longest = 0;
  std::size_t n_elements = 0;
  for (std::size_t i = 0; i < elements.n_nodes(); ++i) {
    if (!elements.exists[i]) continue;
    grid.middle[i] = 0.5 * (position.at(i) + position.at(i + 1));
    longest = std::max(longest, length(position.at(i + 1) - position.at(i)));
    box.add(grid.middle[i]);
    ++n_elements;
  }
  choose_cells(grid, box, longest + reach, n_elements);

  std::vector<std::int32_t> cell_of(elements.n_nodes(), -1);
  grid.start.assign(static_cast<std::size_t>(grid.n[0] * grid.n[1] * grid.n[2]) + 1, 0);
  for (std::size_t i = 0; i < elements.n_nodes(); ++i) {
    if (!elements.exists[i]) continue;
    const std::size_t cell = grid.index(grid.cell_of(grid.middle[i]));
    cell_of[i] = static_cast<std::int32_t>(cell);
    ++grid.start[cell + 1];
  }
  for (std::size_t c = 1; c < grid.start.size(); ++c) grid.start[c] += grid.start[c - 1];
  std::vector<std::int32_t> next(grid.start.begin(), grid.start.end() - 1);
  grid.members.resize(n_elements);
  for (std::size_t i = 0; i < elements.n_nodes(); ++i) {
    if (cell_of[i] < 0) continue;
    const auto slot = static_cast<std::size_t>(next[static_cast<std::size_t>(cell_of[i])]++);
    grid.members[slot] = static_cast<std::int32_t>(i);
  }
  return grid;
}

/// Distance of two elements' chords against a reach [mm], with a cheap look at the middles first.
bool within_reach(const model::VectorArray& position, const Grid& grid, std::size_t a, std::size_t b, double reach) {
  const Vector3 u = position.at(a + 1) - position.at(a);
  const Vector3 v = position.at(b + 1) - position.at(b);
  const double far = reach + 0.5 * (length(u) + length(v));
  const Vector3 between = grid.middle[b] - grid.middle[a];
  if (dot(between, between) > far * far) return false;
  const ClosestPoints at = closest_points(position.at(a), u, position.at(b), v);
  const Vector3 gap = position.at(b) + at.t * v - position.at(a) - at.s * u;
  return dot(gap, gap) < reach * reach;
}

}  // namespace

bool too_near_along_yarn(const ContactElements& elements, std::size_t first, std::size_t second) {
  if (elements.yarn[first] != elements.yarn[second]) return false;
  if (second <= first + 1) return true;
  const double diameter = elements.radius[first] + elements.radius[second];
  return elements.arc_length[second] - elements.arc_length[first + 1] < kSelfContactArc * std::numbers::pi * diameter;
}

std::vector<ElementPair> find_neighbours(const ContactElements& elements, const model::VectorArray& position,
                                         const std::vector<double>& bulge, double skin) {
  const double largest_bulge = *std::max_element(bulge.begin(), bulge.end());
  const Grid grid = make_grid(elements, position, 2 * elements.largest_radius + skin + 2 * largest_bulge);
  std::vector<ElementPair> pairs;
  for (std::size_t a = 0; a < elements.n_nodes(); ++a) {
    if (!elements.exists[a]) continue;
    const auto first_of_row = pairs.size();
    const auto home = grid.cell_of(grid.middle[a]);
    for (std::int64_t z = std::max<std::int64_t>(home[2] - 1, 0); z <= std::min(home[2] + 1, grid.n[2] - 1); ++z) {
      for (std::int64_t y = std::max<std::int64_t>(home[1] - 1, 0); y <= std::min(home[1] + 1, grid.n[1] - 1); ++y) {
        const std::size_t from = grid.index({std::max<std::int64_t>(home[0] - 1, 0), y, z});
        const std::size_t to = grid.index({std::min(home[0] + 1, grid.n[0] - 1), y, z});
        for (auto m = grid.start[from]; m < grid.start[to + 1]; ++m) {
          const auto b = static_cast<std::size_t>(grid.members[static_cast<std::size_t>(m)]);
          if (b <= a || too_near_along_yarn(elements, a, b)) continue;
          const double reach = elements.radius[a] + elements.radius[b] + skin + bulge[a] + bulge[b];
          if (!within_reach(position, grid, a, b, reach)) continue;
          pairs.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
        }
      }
    }
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(first_of_row), pairs.end(),
              [](ElementPair p, ElementPair q) { return p.second < q.second; });
  }
  return pairs;
}

}  // namespace knitmech::contact
