#include "contact/curve_distance.h"

#include <algorithm>
#include <cmath>

namespace knitmech::contact {

namespace {

constexpr int kMostIterations = 12;
/// Change of a place below which the next iteration could only change rounding, since the error is squared each time
/// [-].
constexpr double kConverged = 1e-7;

/// Derivatives of |between|^2 / 2.
struct Bend {
  double ss, st, tt;
};

CurveApproach at(const Curve& first, const Curve& second, double s, double t) {
  CurveApproach here{};
  here.s = s;
  here.t = t;
  here.between = combine(second, hermite(t)) - combine(first, hermite(s));
  here.first_slope = combine(first, hermite_slope(s));
  here.second_slope = combine(second, hermite_slope(t));
  here.first_bend = combine(first, hermite_bend(s));
  here.second_bend = combine(second, hermite_bend(t));
  here.slope_s = -dot(here.between, here.first_slope);
  here.slope_t = dot(here.between, here.second_slope);
  return here;
}

Bend bend_of(const CurveApproach& here) {
  return {dot(here.first_slope, here.first_slope) - dot(here.between, here.first_bend),
          -dot(here.first_slope, here.second_slope),
          dot(here.second_slope, here.second_slope) + dot(here.between, here.second_bend)};
}

/// Whether a place is pushed against the end that it stands at.
bool is_held(double place, double slope) {
  return (place <= 0 && slope > 0) || (place >= 1 && slope < 0);
}

struct Step {
  double s, t;
};

Step newton_step(const CurveApproach& here, bool free_s, bool free_t) {
  Bend bend = bend_of(here);
  const bool convex = bend.ss > 0 && bend.tt > 0 && (!free_s || !free_t || bend.ss * bend.tt > bend.st * bend.st);
  if (!convex) {
    bend.ss = dot(here.first_slope, here.first_slope);
    bend.tt = dot(here.second_slope, here.second_slope);
  }
  if (!free_s) return {0, free_t ? -here.slope_t / bend.tt : 0};
  if (!free_t) return {-here.slope_s / bend.ss, 0};
  // Parallel tangents leave the linearised problem without a unique answer; then each place goes its own way.
  const double determinant = bend.ss * bend.tt - bend.st * bend.st;
  if (determinant <= 1e-10 * bend.ss * bend.tt) return {-0.5 * here.slope_s / bend.ss, -0.5 * here.slope_t / bend.tt};
  return {(bend.st * here.slope_t - bend.tt * here.slope_s) / determinant,
          (bend.st * here.slope_s - bend.ss * here.slope_t) / determinant};
}

}  // namespace

CurveApproach closest_on_curves(const Curve& first, const Curve& second, double s, double t) {
  constexpr double kLargestStep = 0.5;
  for (int i = 0; i < kMostIterations; ++i) {
    CurveApproach here = at(first, second, s, t);
    const bool free_s = !is_held(s, here.slope_s);
    const bool free_t = !is_held(t, here.slope_t);
    const Step step = newton_step(here, free_s, free_t);
    const double s_new = std::clamp(s + std::clamp(step.s, -kLargestStep, kLargestStep), 0.0, 1.0);
    const double t_new = std::clamp(t + std::clamp(step.t, -kLargestStep, kLargestStep), 0.0, 1.0);
    const double change = std::max(std::abs(s_new - s), std::abs(t_new - t));
    s = s_new;
    t = t_new;
    if (change < kConverged) {
      here = at(first, second, s, t);
      const Bend bend = bend_of(here);
      const bool convex_s = !free_s || bend.ss > 0;
      const bool convex_t = !free_t || bend.tt > 0;
      here.is_minimum = convex_s && convex_t && (!free_s || !free_t || bend.ss * bend.tt > bend.st * bend.st);
      return here;
    }
  }
  return at(first, second, s, t);
}

}  // namespace knitmech::contact
