#include "contact/yarn_end.h"

#include <algorithm>
#include <cmath>

#include "contact/overlap.h"

namespace knitmech::contact {

namespace {

/// Least curvature of a gap [over the sum of the radii]: yarns whose gap is flatter lie side by side, which is for the
/// samples to count, and would seem to overlap far beyond the place that is looked at.
constexpr double kFlat = 0.1;

/// Resultant at two places a step beside the closest ones.
CutLoad resultant(const YarnElements& elements, const Centreline& line, YarnPlace first, YarnPlace second,
                  const CutOverlap& overlap, double scale) {
  CutLoad cut;
  cut.first = walk(elements, first);
  cut.second = walk(elements, second);
  const Vector3 a = combine(line.curve(static_cast<std::size_t>(cut.first.element)), hermite(cut.first.share));
  const Vector3 b = combine(line.curve(static_cast<std::size_t>(cut.second.element)), hermite(cut.second.share));
  const Vector3 between = b - a;
  cut.normal = (1 / length(between)) * between;
  cut.load = scale * overlap.sum.force;
  cut.tangent = scale * overlap.sum.tangent;
  cut.energy = scale * overlap.sum.energy;
  return cut;
}

}  // namespace

CutLoad crossing_at_end(const YarnElements& elements, const Centreline& line, const Followed& closest,
                        const PairSize& size) {
  const double distance = length(closest.at.between);
  const Hessian& m = closest.hessian;
  const double tt = std::max(m.tt, kFlat * dot(closest.at.second.slope, closest.at.second.slope));
  const double falls = -closest.slope_first / distance;
  const double along = (m.ss - falls * falls) / distance;
  const double a = size.first_length;
  const double curvature = std::max((along - m.st * m.st / (tt * distance)) / (a * a), kFlat / size.radii);
  const ToEnds ends = to_ends(elements, closest.first);
  const CutOverlap overlap =
      integrate_cut({size.radii - distance, -falls / a, curvature, -ends.back, ends.ahead}, [&](double depth) {
        const StripLaw law = strip_law(depth, size.radii);
        return LawValues{law.force, law.tangent, law.energy};
      });
  const double scale = size.density * size.second_length * std::sqrt(distance / tt);
  const double ds = overlap.centre / a;
  return resultant(elements, line, {closest.first.element, closest.first.share + ds},
                   {closest.second.element, closest.second.share - ds * m.st / tt}, overlap, scale);
}

CutLoad sample_at_end(const YarnElements& elements, const Centreline& line, const Followed& nearest,
                      const PairSize& size, double weight) {
  const double distance = length(nearest.at.between);
  const double b = size.second_length;
  const double rises = nearest.slope_second / distance;
  const double across = (nearest.hessian.tt - rises * rises) / distance;
  const double curvature = std::max(across / (b * b), kFlat / size.radii);
  const ToEnds ends = to_ends(elements, nearest.second);
  const CutOverlap overlap =
      integrate_cut({size.radii - distance, rises / b, curvature, -ends.back, ends.ahead}, [&](double depth) {
        return LawValues{normal_force(depth, size.radii), normal_tangent(depth, size.radii),
                         normal_energy(depth, size.radii)};
      });
  return resultant(elements, line, nearest.first, {nearest.second.element, nearest.second.share + overlap.centre / b},
                   overlap, size.density * weight);
}

}  // namespace knitmech::contact
