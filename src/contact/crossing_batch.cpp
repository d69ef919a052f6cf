#include "contact/crossing_batch.h"

#include <cmath>

#include "contact/closest_places.h"
#include "contact/constants.h"
#include "contact/friction.h"
#include "contact/line_potential.h"

namespace knitmech::contact {

namespace {

KNITMECH_INLINE Vector3 velocity(const LaneSides& side, std::size_t k) {
  return velocity_of(element(side, k).hold(hermite(side.share[k])), side.start_velocity.at(k), side.end_velocity.at(k),
                     side.start_turning.at(k), side.end_turning.at(k));
}

KNITMECH_INLINE void give_to_nodes(LaneSides& side, std::size_t k, const CurveLoad& load) {
  const EndLoads ends = element(side, k).to_nodes(side.share[k], load);
  side.start_force.set(k, ends.start_force);
  side.end_force.set(k, ends.end_force);
  side.start_moment.set(k, ends.start_moment);
  side.end_moment.set(k, ends.end_moment);
}

/// 1 if a < b, else 0; products of these take the place of "and", at which the processor would have to branch.
KNITMECH_INLINE double less(double a, double b) {
  return a < b ? 1.0 : 0.0;
}

/// 1 if a small step stays on the element, else 0.
KNITMECH_INLINE double stays(double share, double step) {
  return less(std::abs(step), kFineStep) * (1 - less(share + step, 0)) * (1 - less(1, share + step));
}

/// Friction, and both loads to the nodes.
KNITMECH_INLINE void finish(ContactBatch& b, std::size_t k, double step, PairLoad& pair, Vector3 normal) {
  const Vector3 motion = step * (velocity(b.second, k) - velocity(b.first, k));
  b.turned_round[k] = dot(b.normal.at(k), normal) < 0 ? 1 : 0;
  const double stiffness = b.stick_stiffness[k];
  const Slide slide = slide_stick(b.elastic_slip.at(k), normal, motion, b.friction[k] * pair.load, stiffness);
  b.loss[k] = slide.loss;
  b.slid[k] = slide.slid;
  b.slipped[k] = slide.slips;
  b.elastic_slip.set(k, slide.elastic_slip);
  b.normal.set(k, normal);

  const Vector3 friction = -stiffness * slide.elastic_slip;
  pair.on_first.force = pair.on_first.force - friction;
  pair.on_second.force = pair.on_second.force + friction;
  give_to_nodes(b.first, k, pair.on_first);
  give_to_nodes(b.second, k, pair.on_second);
  b.load[k] = pair.load;
  b.tangent[k] = pair.tangent;
  b.energy[k] = pair.energy;
}

KNITMECH_INLINE void evaluate_crossing(ContactBatch& b, std::size_t k, double step) {
  Places at = places_at(point_at(element(b.first, k).curve(), b.first.share[k]),
                        point_at(element(b.second, k).curve(), b.second.share[k]));
  Hessian m = hessian(at);
  const double slope_s = -dot(at.between, at.first.slope);
  const double slope_t = dot(at.between, at.second.slope);
  double regular = less(0, m.ss) * less(0, m.tt) * less(0, m.determinant());
  const double determinant = regular > 0 ? m.determinant() : 1;
  const double ds = (m.st * slope_t - m.tt * slope_s) / determinant;
  const double dt = (m.st * slope_s - m.ss * slope_t) / determinant;
  regular *= stays(b.first.share[k], ds) * stays(b.second.share[k], dt);
  b.first.share[k] += ds;
  b.second.share[k] += dt;
  at = places_at(shifted(at.first, ds), shifted(at.second, dt));
  m = hessian(at);
  const double distance = length(at.between);
  const double penetration = b.radii[k] - distance;
  const PairSize size{b.radii[k], b.density[k], b.first.length[k], b.second.length[k]};
  const double across = 2 * penetration * distance;
  const double reach_s = across * size.first_length * size.first_length * m.tt;
  const double reach_t = across * size.second_length * size.second_length * m.ss;
  const double to_first_end = b.first.to_end[k] * b.first.to_end[k] * m.determinant();
  const double to_second_end = b.second.to_end[k] * b.second.to_end[k] * m.determinant();
  b.regular[k] = regular * less(0, penetration) * (1 - less(kSmallOverlap * size.radii, penetration)) *
                 less(reach_s, to_first_end) * less(reach_t, to_second_end) *
                 less(reach_s + reach_t, kLongestOverlap * kLongestOverlap * size.radii * size.radii * m.determinant());
  b.penetration[k] = penetration;
  PairLoad pair = crossing_load<SmallOverlap>(at, m, distance, size);
  finish(b, k, step, pair, (1 / distance) * at.between);
}

}  // namespace

KNITMECH_VECTORISE void evaluate_crossings(ContactBatch& batch, double step) {
#pragma omp simd
  for (std::size_t k = 0; k < kLanes; ++k) evaluate_crossing(batch, k, step);
}

}  // namespace knitmech::contact
