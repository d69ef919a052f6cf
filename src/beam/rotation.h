#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/vectorise.h"

namespace knitmech::beam {

/// Coefficients a_n of  phi / sin(phi) = sum a_n (1 - cos(phi))^n,  a_0 = 1, a_n = a_(n-1) n / (2n + 1).
///
/// It is used after one halving of the angle. For relative rotations up to 180 degrees, y is at most 1 - cos(45 deg) =
/// 0.293 and the terms fall by 0.15 each, so twenty of them are exact to rounding; at 270 degrees they are to 1e-11, at
/// 330 degrees to 1e-7.
inline constexpr int kAngleTerms = 20;

/// The coefficients from a_1 on.
constexpr std::array<double, kAngleTerms> angle_series() {
  std::array<double, kAngleTerms> series{};
  double coefficient = 1;
  for (int n = 1; n <= kAngleTerms; ++n) {
    coefficient *= static_cast<double>(n) / (2.0 * n + 1.0);
    series[static_cast<std::size_t>(n - 1)] = coefficient;
  }
  return series;
}
inline constexpr std::array<double, kAngleTerms> kAngleSeries = angle_series();

/// The terms of sum a_(n+1) y^n from `n` on, every `stride`-th, as a polynomial in `power` = y^stride, by Horner's
/// rule. Written out by the compiler: a loop in here would keep the loop over elements scalar.
template <std::size_t n, std::size_t stride>
KNITMECH_INLINE double angle_terms(double power) {
  if constexpr (n + stride >= kAngleSeries.size()) {
    return kAngleSeries[n];
  } else {
    return kAngleSeries[n] + power * angle_terms<n + stride, stride>(power);
  }
}

/// sum a_(n+1) y^n. In four sums that do not wait for each other: the processor has something to do meanwhile.
KNITMECH_INLINE double angle_polynomial(double y) {
  const double y2 = y * y;
  const double y4 = y2 * y2;
  return (angle_terms<0, 4>(y4) + y * angle_terms<1, 4>(y4)) + y2 * (angle_terms<2, 4>(y4) + y * angle_terms<3, 4>(y4));
}

/// What a relative rotation needs besides its quaternion (cos phi, u sin phi), phi = half the angle, 0 <= phi < 180
/// deg.
struct HalfAngle {
  double ratio;        ///< f = phi / sin(phi): the rotation vector is 2 f u sin(phi)
  double ratio_slope;  ///< g = (1 - f) / sin^2(phi), smooth through phi = 0
  double cos_half;     ///< cos(phi / 2)
};

/// Without branches or trigonometric functions, so that it vectorises: one halving of the angle, then the series above.
/// \param cosine cos(phi), in (-1, 1]
KNITMECH_INLINE HalfAngle half_angle(double cosine) {
  const double cos_half = std::sqrt(0.5 * (1 + cosine));
  const double y = 1 - cos_half;
  const double sum = 1 + angle_polynomial(y);
  return {1 + y * sum / cos_half, -sum / (2 * cos_half * (1 + cos_half) * (1 + cosine)), cos_half};
}

}  // namespace knitmech::beam
