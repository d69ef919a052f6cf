#include "compare/knot_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "compare/constants.h"
#include "compare/least_of.h"

namespace knitmech::compare {
namespace {

/// The fit for one knot; place is the strain from 0 to 1.
struct LinesAt {
  Eigen::Vector3d coefficients;  ///< a, b, c
  double residual = 0;           ///< sum of squares
};

LinesAt lines_at(double knot, std::span<const double> places, std::span<const double> forces) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d basis(1, places[i], std::max(0.0, places[i] - knot));
    normal += basis * basis.transpose();
    right += forces[i] * basis;
  }
  LinesAt lines{normal.ldlt().solve(right), 0};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d basis(1, places[i], std::max(0.0, places[i] - knot));
    const double difference = forces[i] - basis.dot(lines.coefficients);
    lines.residual += difference * difference;
  }
  return lines;
}

}  // namespace

KnotFit fit_knot(std::span<const double> strains, std::span<const double> forces) {
  const double from = strains.front();
  const double length = strains.back() - from;
  std::vector<double> places;
  places.reserve(strains.size());
  for (const double strain : strains) places.push_back((strain - from) / length);

  constexpr std::size_t kKnotsTried = 100;
  const double place = least_of(kKnotMargin, 1 - kKnotMargin, kKnotsTried,
                                [&](double knot) { return lines_at(knot, places, forces).residual; });
  const LinesAt lines = lines_at(place, places, forces);
  KnotFit fit;
  fit.knot = from + place * length;
  fit.initial_slope = lines.coefficients[1] / length;
  fit.locked_slope = (lines.coefficients[1] + lines.coefficients[2]) / length;
  fit.rms = std::sqrt(lines.residual / static_cast<double>(strains.size()));
  if (fit.locked_slope - fit.initial_slope > kLeastLocking * std::abs(fit.locked_slope)) fit.locking_strain = fit.knot;
  return fit;
}

}  // namespace knitmech::compare
