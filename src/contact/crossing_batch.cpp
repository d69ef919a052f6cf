#include "contact/crossing_batch.h"

#include <cmath>

#include "contact/closest_places.h"
#include "contact/constants.h"
#include "contact/friction.h"
#include "contact/line_potential.h"

namespace knitmech::contact {

namespace {

KNITMECH_INLINE Curve curve_of(const LaneSides& side, std::size_t k) {
  const double size = side.length[k];
  return {side.start.at(k), side.end.at(k), size * side.start_tangent.at(k), size * side.end_tangent.at(k),
          side.start_bow.at(k) + side.end_bow.at(k)};
}

KNITMECH_INLINE Vector3 velocity_of(const LaneSides& side, std::size_t k, HermiteWeights by) {
  const double size = side.length[k];
  const Vector3 start_arm = (size * by.start_slope) * side.start_tangent.at(k) + by.bow * side.start_bow.at(k);
  const Vector3 end_arm = (size * by.end_slope) * side.end_tangent.at(k) + by.bow * side.end_bow.at(k);
  return by.start * side.start_velocity.at(k) + by.end * side.end_velocity.at(k) +
         cross(side.start_turning.at(k), start_arm) + cross(side.end_turning.at(k), end_arm);
}

/// See Centreline::spread().
KNITMECH_INLINE void spread(LaneSides& side, std::size_t k, HermiteWeights value, double place, const CurveLoad& load) {
  const HermiteWeights slope = hermite_slope(place);
  const HermiteWeights bend = hermite_bend(place);
  const double size = side.length[k];
  const Vector3 on_end = value.end * load.force + slope.end * load.slope + bend.end * load.bend;
  const Vector3 on_bow = value.bow * load.force + slope.bow * load.slope + bend.bow * load.bend;
  const Vector3 turns_start =
      value.start_slope * load.force + slope.start_slope * load.slope + bend.start_slope * load.bend;
  const Vector3 turns_end = value.end_slope * load.force + slope.end_slope * load.slope + bend.end_slope * load.bend;
  side.start_force.set(k, load.force - on_end);
  side.end_force.set(k, on_end);
  side.start_moment.set(k, size * cross(side.start_tangent.at(k), turns_start) + cross(side.start_bow.at(k), on_bow));
  side.end_moment.set(k, size * cross(side.end_tangent.at(k), turns_end) + cross(side.end_bow.at(k), on_bow));
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
  const double s = b.first.share[k];
  const double t = b.second.share[k];
  const HermiteWeights first_weights = hermite(s);
  const HermiteWeights second_weights = hermite(t);
  const Vector3 motion = step * (velocity_of(b.second, k, second_weights) - velocity_of(b.first, k, first_weights));
  b.turned_round[k] = dot(b.normal.at(k), normal) < 0 ? 1 : 0;

  const double stiffness = b.stick_stiffness[k];
  const double limit = b.friction[k] * pair.load;
  const Vector3 old = b.elastic_slip.at(k);
  const Vector3 flat = old - dot(old, normal) * normal;
  const double flat_squared = dot(flat, flat);
  const double turned = flat_squared > 0 ? std::sqrt(dot(old, old) / (flat_squared > 0 ? flat_squared : 1)) : 1;
  const Vector3 before = turned * flat;
  const Vector3 stretched = before + motion - dot(motion, normal) * normal;
  const double size = std::sqrt(dot(stretched, stretched));
  const bool slips = stiffness * size > limit;
  const double kept = slips ? limit / (slips ? stiffness * size : 1) : 1;
  const Vector3 slip = kept * stretched;
  const double cut = stiffness * std::sqrt(dot(before, before)) - limit;
  b.loss[k] = slips ? limit * (1 - kept) * size + (cut > 0 ? 0.5 * cut * cut / stiffness : 0) : 0;
  b.slid[k] = (1 - kept) * size;
  b.slipped[k] = slips ? 1 : 0;
  b.elastic_slip.set(k, slip);
  b.normal.set(k, normal);

  const Vector3 friction = (-stiffness) * slip;
  pair.on_first.force = pair.on_first.force - friction;
  pair.on_second.force = pair.on_second.force + friction;
  spread(b.first, k, first_weights, s, pair.on_first);
  spread(b.second, k, second_weights, t, pair.on_second);
  b.load[k] = pair.load;
  b.tangent[k] = pair.tangent;
  b.energy[k] = pair.energy;
}

KNITMECH_INLINE void evaluate_crossing(ContactBatch& b, std::size_t k, double step) {
  Places at =
      places_at(point_at(curve_of(b.first, k), b.first.share[k]), point_at(curve_of(b.second, k), b.second.share[k]));
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

KNITMECH_INLINE void evaluate_sample(ContactBatch& b, std::size_t k, double step) {
  Places at =
      places_at(point_at(curve_of(b.first, k), b.first.share[k]), point_at(curve_of(b.second, k), b.second.share[k]));
  Hessian m = hessian(at);
  const double slope_t = dot(at.between, at.second.slope);
  double regular = less(0, m.tt);
  const double dt = -slope_t / (regular > 0 ? m.tt : 1);
  regular *= stays(b.second.share[k], dt);
  b.second.share[k] += dt;
  at = places_at(at.first, shifted(at.second, dt));
  m = hessian(at);
  const double distance = length(at.between);
  const double penetration = b.radii[k] - distance;
  const PairSize size{b.radii[k], b.density[k], b.first.length[k], b.second.length[k]};
  const double across = 2 * penetration * distance * size.second_length * size.second_length;
  b.regular[k] = regular * less(0, m.tt) * less(0, penetration) * (1 - less(kSmallOverlap * size.radii, penetration)) *
                 less(across, b.second.to_end[k] * b.second.to_end[k] * m.tt);
  b.penetration[k] = penetration;
  PairLoad pair = sample_load<SmallOverlap>(at, m, distance, size, b.weight[k]);
  finish(b, k, step, pair, (1 / distance) * at.between);
}

}  // namespace

KNITMECH_VECTORISE void evaluate_crossings(ContactBatch& batch, double step) {
#pragma omp simd
  for (std::size_t k = 0; k < kLanes; ++k) evaluate_crossing(batch, k, step);
}

KNITMECH_VECTORISE void evaluate_samples(ContactBatch& batch, double step) {
#pragma omp simd
  for (std::size_t k = 0; k < kLanes; ++k) evaluate_sample(batch, k, step);
}

}  // namespace knitmech::contact
