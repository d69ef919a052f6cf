#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vectorise.h"

namespace knitmech::contact {

/// The normal law (normal_law.h) by squares of distances, which are polynomials along a yarn where distances are not,
/// and its integral over a cell: a short stretch of one yarn as a point of another yarn sees it.
///
/// The depth by squares of two points at the distance r is
///
///     p = (D^2 - r^2) / (2 D)          = d to first order, d = D - r the penetration, D the sum of the radii

/// Greatest depth that is computed with [mm]: finite numbers for a run that has gone wrong, so that it can say so. The
/// centrelines meet at D / 2.
KNITMECH_INLINE double deepest_depth(double radii) {
  return 0.5 * 0.999999 * radii;
}

/// The law at a place.
struct LawByDepth {
  double energy;   ///< e [mm^2]  =  D^2 (sqrt(1 - u) - 1 - ln(1 - u) / 2), u = 2 p / D;  = p^2 / 2 + ...
  double force;    ///< its derivative by p [mm]  =  D (1 / (1 - u) - 1 / sqrt(1 - u))
  double tangent;  ///< the derivative of that [-]
};

/// u below which the series of the energy is exact to 1e-6.
inline constexpr double kSmallDepth = 0.1;

/// @pre depth < D / 2: the points do not coincide
KNITMECH_INLINE LawByDepth law_by_depth(double depth, double radii) {
  const double u = 2 * depth / radii;
  const double inverse = 1 / (1 - u);
  const double root = std::sqrt(inverse);
  const double energy =
      u < kSmallDepth
          ? u * u *
                (1.0 / 8 + u * (5.0 / 48 + u * (11.0 / 128 + u * (93.0 / 1280 + u * (193.0 / 3072 + u * 793 / 14336)))))
          : 1 / root - 1 + 0.5 * std::log(inverse);
  return {radii * radii * energy, radii * (inverse - root), 2 * inverse * (inverse - 0.5 * root)};
}

/// Stretches of a cell on which the depth is above 0, as shares of the cell.
struct DeepStretches {
  int n = 0;
  std::array<double, 2> from{}, to{};
  void add(double low, double high) {
    low = std::max(low, 0.0);
    high = std::min(high, 1.0);
    if (!(low < high)) return;
    from[static_cast<std::size_t>(n)] = low;
    to[static_cast<std::size_t>(n)] = high;
    ++n;
  }
};

/// Where a + b x + c x^2 > 0 for x from 0 to 1.
inline DeepStretches deep_stretches(double a, double b, double c) {
  DeepStretches deep;
  const double determinant = b * b - 4 * a * c;
  if (determinant <= 0 || (b == 0 && c == 0)) {
    if (a > 0 && (c >= 0 || determinant > 0)) deep.add(0, 1);
    return deep;
  }
  const double q = -0.5 * (b + std::copysign(std::sqrt(determinant), b));
  const double one = q / c;  // infinite for c = 0
  const double other = a / q;
  const double low = std::min(one, other);
  const double high = std::max(one, other);
  if (c < 0) {
    deep.add(low, high);
  } else {
    deep.add(0, low);
    deep.add(high, 1);
  }
  return deep;
}

/// The law integrated along a cell.
struct CellLoad {
  double energy = 0;              ///< [mm^2], times the length of the cell
  double tangent = 0;             ///< [-]
  std::array<double, 3> force{};  ///< derivatives of the energy by the three depths [mm]
  [[nodiscard]] double total() const { return force[0] + force[1] + force[2]; }
};

/// Integrates the law along a cell on which the depth is the parabola through its values at the start, the middle and
/// the end: by four Gauss points on each stretch where the depth is above 0. They are exact for the first three terms
/// of the law, so that the forces are the derivatives of the energy to better than 1e-5.
/// \param radii D [mm]
inline CellLoad integrate_cell(double start, double middle, double end, double radii) {
  constexpr std::array<double, 4> kPlaces = {0.069431844202973712, 0.330009478207571868, 0.669990521792428132,
                                             0.930568155797026288};
  constexpr std::array<double, 4> kWeights = {0.173927422568726929, 0.326072577431273071, 0.326072577431273071,
                                              0.173927422568726929};
  CellLoad cell;
  const double b = 4 * middle - 3 * start - end;
  const double c = 2 * (start + end - 2 * middle);
  const DeepStretches deep = deep_stretches(start, b, c);
  for (int k = 0; k < deep.n; ++k) {
    const double from = deep.from[static_cast<std::size_t>(k)];
    const double size = deep.to[static_cast<std::size_t>(k)] - from;
    for (std::size_t g = 0; g < kPlaces.size(); ++g) {
      const double x = from + kPlaces[g] * size;
      const LawByDepth law = law_by_depth(std::max(start + x * (b + x * c), 0.0), radii);
      const double weight = kWeights[g] * size;
      cell.energy += weight * law.energy;
      cell.tangent += weight * law.tangent;
      const double force = weight * law.force;
      cell.force[0] += force * (1 - x) * (1 - 2 * x);
      cell.force[1] += force * 4 * x * (1 - x);
      cell.force[2] += force * x * (2 * x - 1);
    }
  }
  return cell;
}

}  // namespace knitmech::contact
