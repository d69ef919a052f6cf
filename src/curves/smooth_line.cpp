#include "curves/smooth_line.h"

#include "base/errors.h"

namespace knitmech::curves {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points without_repeats(const Points& points) {
  Points kept = {points.front()};
  for (const Eigen::Vector3d& point : points) {
    if (point != kept.back()) kept.push_back(point);
  }
  if (kept.size() < 2) throw InputError("all of its points coincide");
  return kept;
}

/// The cubic from a to b with these derivatives with respect to a parameter that grows by 1.
CubicArc hermite(const Eigen::Vector3d& a, const Eigen::Vector3d& slope_a, const Eigen::Vector3d& b,
                 const Eigen::Vector3d& slope_b) {
  return {{a, a + slope_a / 3, b - slope_b / 3, b}};
}

CubicArc straight(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return hermite(a, b - a, b, b - a);
}

/// Derivatives of the natural cubic spline at its points, by the length of the chords. With h the chords and d the
/// slopes of the chords: m[i-1] / h[i-1] + 2 m[i] (1 / h[i-1] + 1 / h[i]) + m[i+1] / h[i] =
/// 3 (d[i-1] / h[i-1] + d[i] / h[i]); at an end 2 m + m of its neighbour = 3 d. (De Boor, A Practical Guide to Splines,
/// chapter IV.) Solved by elimination.
Points spline_slopes(const Points& points, const std::vector<double>& chords) {
  const std::size_t n = points.size();
  Points slopes(n, Eigen::Vector3d::Zero());
  std::vector<double> above(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const double before = i > 0 ? 1 / chords[i - 1] : 0;
    const double behind = i + 1 < n ? 1 / chords[i] : 0;
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    if (i > 0) right += 3 * before * before * (points[i] - points[i - 1]);
    if (i + 1 < n) right += 3 * behind * behind * (points[i + 1] - points[i]);
    const double pivot = 2 * (before + behind) - (i > 0 ? before * above[i - 1] : 0);
    if (i > 0) right -= before * slopes[i - 1];
    above[i] = behind / pivot;
    slopes[i] = right / pivot;
  }
  for (std::size_t i = n - 1; i-- > 0;) {
    slopes[i] -= above[i] * slopes[i + 1];
  }
  return slopes;
}

std::vector<CubicArc> through_all(const Points& given) {
  const Points points = without_repeats(given);
  std::vector<double> chords;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    chords.push_back((points[i + 1] - points[i]).norm());
  }
  const Points slopes = spline_slopes(points, chords);
  std::vector<CubicArc> arcs;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    arcs.push_back(hermite(points[i], chords[i] * slopes[i], points[i + 1], chords[i] * slopes[i + 1]));
  }
  return arcs;
}

std::vector<CubicArc> through_inner(const Points& points) {
  static_cast<void>(without_repeats({points.begin() + 1, points.end() - 1}));
  std::vector<CubicArc> arcs;
  for (std::size_t i = 1; i + 2 < points.size(); ++i) {
    arcs.push_back(
        hermite(points[i], (points[i + 1] - points[i - 1]) / 2, points[i + 1], (points[i + 2] - points[i]) / 2));
  }
  return arcs;
}

std::vector<CubicArc> between_middles(const Points& given) {
  const Points points = without_repeats(given);
  const auto middle = [&](std::size_t i) { return Eigen::Vector3d((points[i] + points[i + 1]) / 2); };
  std::vector<CubicArc> arcs = {straight(points.front(), middle(0))};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    // A quadratic arc with the corner p leaves a by 2 (p - a) and reaches b by 2 (b - p).
    arcs.push_back(hermite(middle(i - 1), points[i] - points[i - 1], middle(i), points[i + 1] - points[i]));
  }
  arcs.push_back(straight(middle(points.size() - 2), points.back()));
  return arcs;
}

}  // namespace

Eigen::Vector3d CubicArc::point(double share) const {
  const double rest = 1 - share;
  return rest * rest * rest * corners[0] + 3 * rest * rest * share * corners[1] +
         3 * rest * share * share * corners[2] + share * share * share * corners[3];
}

Eigen::Vector3d CubicArc::derivative(double share) const {
  const double rest = 1 - share;
  return 3 * (rest * rest * (corners[1] - corners[0]) + 2 * rest * share * (corners[2] - corners[1]) +
              share * share * (corners[3] - corners[2]));
}

std::vector<CubicArc> smooth_line(const YarnLine& yarn, LineKind kind) {
  switch (kind) {
    case LineKind::through_points:
      return through_all(yarn.points);
    case LineKind::inner_points:
      return through_inner(yarn.points);
    case LineKind::midpoints:
      break;
  }
  return between_middles(yarn.points);
}

}  // namespace knitmech::curves
