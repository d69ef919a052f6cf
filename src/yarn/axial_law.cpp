#include "yarn/axial_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "base/errors.h"

namespace knitmech::yarn {
namespace {

/// How far the slope at an end may be from the secant there [-], both ways; 3 is the most with which a cubic between
/// rising points surely rises.
constexpr double kEndSlopeRatio = 3;

/// Points nearer to each other than this strain [-] are one point: far below what a testing machine resolves, far above
/// where differences lose their digits.
constexpr double kLeastStrainStep = 1e-9;

[[noreturn]] void refuse(std::size_t index, const std::string& complaint) {
  throw InputError(fmt::format("point {} of the axial law {}.", index + 1, complaint));
}

void check(const std::vector<AxialPoint>& points) {
  if (points.size() < 2) {
    throw InputError(fmt::format("the axial law has {} points, but must have at least 2.", points.size()));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [strain, force] = points[i];
    if (!std::isfinite(strain) || !std::isfinite(force)) refuse(i, "is not finite");
    if (i == 0) {
      if (strain != 0 || force != 0) {
        refuse(i, fmt::format("is strain {}, force {} N, but must be strain 0, force 0 N", strain, force));
      }
      continue;
    }
    const AxialPoint& before = points[i - 1];
    if (!(strain - before.strain >= kLeastStrainStep)) {
      refuse(i, fmt::format("has the strain {} after {}; strains must ascend, by {} at least", strain, before.strain,
                            kLeastStrainStep));
    }
    if (force < before.force) {
      refuse(i, fmt::format("has the force {} N after {} N; the force must not fall", force, before.force));
    }
  }
  if (!(points[1].force > 0)) refuse(1, "has the force 0 N; the force must rise from the first point to the second");
}

/// Slope at an end of the parabola through three points: h the lengths and d the secants of the end's interval (a) and
/// of its neighbour (b).
double end_slope(double h_a, double h_b, double d_a, double d_b) {
  const double parabola = ((2 * h_a + h_b) * d_a - h_a * d_b) / (h_a + h_b);
  return std::clamp(parabola, d_a / kEndSlopeRatio, d_a * kEndSlopeRatio);
}

/// Slope at an inner point, between an interval of length h_a with the secant d_a and one of h_b with d_b.
double inner_slope(double h_a, double h_b, double d_a, double d_b) {
  if (d_a == 0 || d_b == 0) return 0;
  const double weight_a = 2 * h_b + h_a;
  const double weight_b = h_b + 2 * h_a;
  return (weight_a + weight_b) / (weight_a / d_a + weight_b / d_b);
}

std::vector<double> slopes_of(const std::vector<AxialPoint>& points) {
  const std::size_t n_intervals = points.size() - 1;
  std::vector<double> length(n_intervals);
  std::vector<double> secant(n_intervals);
  for (std::size_t i = 0; i < n_intervals; ++i) {
    length[i] = points[i + 1].strain - points[i].strain;
    secant[i] = (points[i + 1].force - points[i].force) / length[i];
  }
  if (n_intervals == 1) return {secant[0], secant[0]};
  const std::size_t last = n_intervals - 1;
  std::vector<double> slopes(points.size());
  slopes.front() = end_slope(length[0], length[1], secant[0], secant[1]);
  for (std::size_t i = 1; i <= last; ++i) {
    slopes[i] = inner_slope(length[i - 1], length[i], secant[i - 1], secant[i]);
  }
  slopes.back() = end_slope(length[last], length[last - 1], secant[last], secant[last - 1]);
  return slopes;
}

}  // namespace

AxialLaw::AxialLaw(const std::vector<AxialPoint>& points) {
  check(points);
  const std::vector<double> slopes = slopes_of(points);
  pieces_.push_back({.slope = slopes.front()});
  largest_slope_ = *std::ranges::max_element(slopes);
  double energy = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = points[i + 1].strain - points[i].strain;
    const double secant = (points[i + 1].force - points[i].force) / length;
    const double half_curvature = (3 * secant - 2 * slopes[i] - slopes[i + 1]) / length;
    const double cubic = (slopes[i] + slopes[i + 1] - 2 * secant) / (length * length);
    pieces_.push_back({points[i].strain, energy, points[i].force, slopes[i], half_curvature, cubic});
    energy +=
        length * (points[i].force + length * (slopes[i] / 2 + length * (half_curvature / 3 + length * cubic / 4)));
    // The slope is a parabola, which has its top within the piece where it bends down and turns inside.
    const double top = cubic < 0 ? -half_curvature / (3 * cubic) : 0;
    if (top > 0 && top < length) {
      largest_slope_ = std::max(largest_slope_, slopes[i] + half_curvature * top);
    }
  }
  pieces_.push_back(
      {.start = points.back().strain, .energy = energy, .force = points.back().force, .slope = slopes.back()});
  make_cells();
}

double AxialLaw::strain_at(double force) const {
  const Piece& last = pieces_.back();
  if (force > last.force) {
    return last.slope > 0 ? last.start + (force - last.force) / last.slope : std::numeric_limits<double>::infinity();
  }
  const auto reaches = [&](double strain) { return this->force(strain) >= force; };
  double below = 0;
  double above = last.start;
  for (;;) {
    const double middle = 0.5 * (below + above);
    if (middle <= below || middle >= above) return above;  // neighbouring doubles
    (reaches(middle) ? above : below) = middle;
  }
}

std::vector<double> AxialLaw::strains() const {
  std::vector<double> strains;
  for (auto piece = pieces_.begin() + 1; piece != pieces_.end(); ++piece) strains.push_back(piece->start);
  return strains;
}

void AxialLaw::make_cells() {
  constexpr std::size_t kCellsPerPiece = 4;
  // Strains that round into the next cell find their piece as well.
  constexpr double kRounding = 1e-6;
  const std::size_t n_cells = kCellsPerPiece * pieces_.size();
  cells_per_strain_ = static_cast<double>(n_cells) / last_strain();
  std::uint32_t piece = 1;
  for (std::size_t cell = 0; cell <= n_cells; ++cell) {
    const double start = (static_cast<double>(cell) - kRounding) / cells_per_strain_;
    while (piece + 2 < pieces_.size() && start >= pieces_[piece + 1].start) ++piece;
    first_piece_.push_back(piece);
  }
}

}  // namespace knitmech::yarn
