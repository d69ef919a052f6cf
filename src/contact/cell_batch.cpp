#include "contact/cell_batch.h"

#include <cmath>

#include "base/vectorise.h"

namespace knitmech::contact {

namespace {

constexpr std::size_t kLanes = 8;

/// u = 2 p / D up to which the series of the law are exact to 1e-6.
constexpr double kSeriesReach = 0.2;

/// e / D^2 = sum over k from 2 of c_k u^k,  c_k = 1 / (2 k) - |binomial(1/2, k)|; see cell_law.h.
constexpr std::size_t kTerms = 9;
constexpr std::array<double, kTerms> energy_series() {
  std::array<double, kTerms> series{};
  double binomial = 0.5;
  for (std::size_t k = 2; k < kTerms + 2; ++k) {
    const auto order = static_cast<double>(k);
    binomial *= (order - 1.5) / order;
    series[k - 2] = 0.5 / order - binomial;
  }
  return series;
}
/// Of the derivative by u, from u on, and of the second one.
constexpr std::array<double, kTerms> force_series() {
  std::array<double, kTerms> series = energy_series();
  for (std::size_t k = 2; k < kTerms + 2; ++k) series[k - 2] *= static_cast<double>(k);
  return series;
}
constexpr std::array<double, kTerms> tangent_series() {
  std::array<double, kTerms> series = force_series();
  for (std::size_t k = 2; k < kTerms + 2; ++k) series[k - 2] *= static_cast<double>(k - 1);
  return series;
}
constexpr std::array<double, kTerms> kEnergySeries = energy_series();
constexpr std::array<double, kTerms> kForceSeries = force_series();
constexpr std::array<double, kTerms> kTangentSeries = tangent_series();

/// The sum of the terms from k on, over u^k; written out, as loops within a loop over lanes would not be vectorised.
template <std::size_t k = 0>
KNITMECH_INLINE double sum_of(const std::array<double, kTerms>& series, double u) {
  if constexpr (k + 1 == kTerms) {
    return series[k];
  } else {
    return series[k] + u * sum_of<k + 1>(series, u);
  }
}

/// The stretch of a cell on which the depth a + b x + c x^2 is above 0, without branches.
struct Stretch {
  double from, to;
  double is_one;  ///< 0 where there are two
};

KNITMECH_INLINE Stretch stretch_of(double a, double end, double b, double c) {
  const double determinant = b * b - 4 * a * c;
  const double root = std::sqrt(determinant > 0 ? determinant : 0.0);
  const double q = -0.5 * (b + (b < 0 ? -root : root));
  constexpr double kTiny = 1e-300;
  const double one = q / (c == 0 ? kTiny : c);
  const double other = a / (q == 0 ? kTiny : q);
  const double low = one < other ? one : other;
  const double high = one < other ? other : one;
  const double start_is_deep = a > 0 ? 1.0 : 0.0;
  const double end_is_deep = end > 0 ? 1.0 : 0.0;
  const double has_roots = determinant > 0 ? 1.0 : 0.0;
  // A depth that bends down is above 0 between its zeros, one that bends up outside of them.
  const double inner_from = low > 0 ? low : 0.0;
  const double inner_to = high < 1 ? high : 1.0;
  const double outer_from = start_is_deep > 0 ? 0.0 : high;
  const double outer_to = end_is_deep > 0 ? 1.0 : low;
  const double any_outside = start_is_deep + end_is_deep;
  const double from = c < 0 ? inner_from : outer_from;
  const double to = c < 0 ? inner_to * has_roots : outer_to * (any_outside > 0 ? 1.0 : 0.0);
  const double from_known = any_outside + (c < 0 ? has_roots : 0.0) > 0 ? from : 0.0;
  const double zeros_within = (c > 0 ? has_roots : 0.0) * (low > 0 ? 1.0 : 0.0) * (high < 1 ? 1.0 : 0.0);
  const double is_two = start_is_deep * end_is_deep * zeros_within;
  return {from_known, to > from_known ? to : from_known, 1 - is_two};
}

struct Lanes {
  const double *start, *middle, *end, *radii;
  double *energy, *tangent, *on_start, *on_middle, *on_end, *irregular;
};

/// What the Gauss points of a cell come to.
struct CellSum {
  double energy = 0, tangent = 0;
  double on_start = 0, on_middle = 0, on_end = 0;
  double greatest = 0;  ///< u
};

/// Adds the Gauss point at a place of the cell, with the depth there.
KNITMECH_INLINE void add_gauss_point(double x, double weight, double depth, double radii, CellSum& sum) {
  const double u = depth > 0 ? 2 * depth / radii : 0.0;
  const double force = weight * u * sum_of(kForceSeries, u);
  sum.energy += weight * u * u * sum_of(kEnergySeries, u);
  sum.tangent += depth > 0 ? weight * sum_of(kTangentSeries, u) : 0.0;
  sum.on_start += force * (1 - x) * (1 - 2 * x);
  sum.on_middle += force * 4 * x * (1 - x);
  sum.on_end += force * x * (2 * x - 1);
  sum.greatest = sum.greatest > u ? sum.greatest : u;
}

KNITMECH_INLINE void integrate_lane(const Lanes& at, std::size_t i) {
  const double a = at.start[i];
  const double middle = at.middle[i];
  const double end = at.end[i];
  const double radii = at.radii[i];
  const double b = 4 * middle - 3 * a - end;
  const double c = 2 * (a + end - 2 * middle);
  const Stretch deep = stretch_of(a, end, b, c);
  const double size = deep.to - deep.from;
  CellSum sum;
  const auto add = [&](double place, double weight) __attribute__((always_inline)) {
    const double x = deep.from + place * size;
    add_gauss_point(x, weight * size, a + x * (b + x * c), radii, sum);
  };
  add(0.069431844202973712, 0.173927422568726929);
  add(0.330009478207571868, 0.326072577431273071);
  add(0.669990521792428132, 0.326072577431273071);
  add(0.930568155797026288, 0.173927422568726929);
  at.energy[i] = radii * radii * sum.energy;
  at.tangent[i] = 4 * sum.tangent;
  at.on_start[i] = 2 * radii * sum.on_start;
  at.on_middle[i] = 2 * radii * sum.on_middle;
  at.on_end[i] = 2 * radii * sum.on_end;
  at.irregular[i] = sum.greatest < kSeriesReach ? 1 - deep.is_one : 1.0;
}

KNITMECH_VECTORISE void integrate_lanes(const Lanes at, std::size_t n) {
  for (std::size_t from = 0; from < n; from += kLanes) {
#pragma omp simd
    for (std::size_t lane = 0; lane < kLanes; ++lane) integrate_lane(at, from + lane);
  }
}

}  // namespace

void CellBatch::make_room(std::size_t n) {
  if (n <= start_.size()) return;
  const std::size_t room = (std::max(n, 2 * start_.size()) + kLanes - 1) / kLanes * kLanes;
  for (auto* values : {&start_, &middle_, &end_, &energy_, &tangent_, &on_start_, &on_middle_, &on_end_, &irregular_}) {
    values->resize(room);
  }
  radii_.resize(room, 1.0);
}

void CellBatch::add(double start, double middle, double end, double radii) {
  make_room(n_ + 1);
  start_[n_] = start;
  middle_[n_] = middle;
  end_[n_] = end;
  radii_[n_] = radii;
  ++n_;
}

void CellBatch::integrate() {
  integrate_lanes({start_.data(), middle_.data(), end_.data(), radii_.data(), energy_.data(), tangent_.data(),
                   on_start_.data(), on_middle_.data(), on_end_.data(), irregular_.data()},
                  (n_ + kLanes - 1) / kLanes * kLanes);
  for (std::size_t i = 0; i < n_; ++i) {
    if (irregular_[i] == 0) continue;
    const CellLoad alone = integrate_cell(start_[i], middle_[i], end_[i], radii_[i]);
    energy_[i] = alone.energy;
    tangent_[i] = alone.tangent;
    on_start_[i] = alone.force[0];
    on_middle_[i] = alone.force[1];
    on_end_[i] = alone.force[2];
  }
}

}  // namespace knitmech::contact
