#include "contact/placed_points.h"

#include <algorithm>

#include "base/vectorise.h"
#include "contact/cell_law.h"

namespace knitmech::contact {

namespace {

/// A curve without its start, which the points are computed from: their weights add up to one.
struct Around {
  Vector3 start, along, start_slope, end_slope, bow;
  explicit Around(const Curve& of)
      : start(of.start), along(of.end - of.start), start_slope(of.start_slope), end_slope(of.end_slope), bow(of.bow) {}
  [[nodiscard]] KNITMECH_INLINE Vector3 at(double end, double slope_start, double slope_end, double on_bow) const {
    return start + end * along + slope_start * start_slope + slope_end * end_slope + on_bow * bow;
  }
};

struct PointArrays {
  double *on_end, *on_start_slope, *on_end_slope, *on_bow, *x, *y, *z, *vx, *vy, *vz, *fx, *fy, *fz;
};

KNITMECH_VECTORISE void place(const PlaceRow row, const Around position, const Around velocity, const PointArrays to) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < rounded_up(row.n); ++i) {
    const double s = row.first + static_cast<double>(static_cast<int>(i)) * row.step;
    const HermiteWeights by = hermite(s);
    to.on_end[i] = by.end;
    to.on_start_slope[i] = by.start_slope;
    to.on_end_slope[i] = by.end_slope;
    to.on_bow[i] = by.bow;
    const Vector3 x = position.at(by.end, by.start_slope, by.end_slope, by.bow);
    const Vector3 v = velocity.at(by.end, by.start_slope, by.end_slope, by.bow);
    to.x[i] = x.x;
    to.y[i] = x.y;
    to.z[i] = x.z;
    to.vx[i] = v.x;
    to.vy[i] = v.y;
    to.vz[i] = v.z;
    to.fx[i] = to.fy[i] = to.fz[i] = 0;
  }
}

KNITMECH_VECTORISE void depths(Vector3 place, double radii, std::size_t n, const double* x, const double* y,
                               const double* z, double* depth) {
  const double inverse = 1 / radii;
  const double deepest = deepest_depth(radii);
#pragma GCC ivdep
  for (std::size_t i = 0; i < rounded_up(n); ++i) {
    const Vector3 between{x[i] - place.x, y[i] - place.y, z[i] - place.z};
    const double value = 0.5 * (radii - dot(between, between) * inverse);
    depth[i] = value < deepest ? value : deepest;
  }
}

struct Components {
  const double *x, *y, *z;
};

KNITMECH_VECTORISE PlacedPoints::WeightedSum weighted_sum(const double* weight, Components x, Components v,
                                                          std::size_t n) {
  double w = 0, px = 0, py = 0, pz = 0, qx = 0, qy = 0, qz = 0;
#pragma omp simd reduction(+ : w, px, py, pz, qx, qy, qz)
  for (std::size_t i = 0; i < rounded_up(n); ++i) {
    w += weight[i];
    px += weight[i] * x.x[i];
    py += weight[i] * x.y[i];
    pz += weight[i] * x.z[i];
    qx += weight[i] * v.x[i];
    qy += weight[i] * v.y[i];
    qz += weight[i] * v.z[i];
  }
  return {w, {px, py, pz}, {qx, qy, qz}};
}

struct ForceArrays {
  double* __restrict x;
  double* __restrict y;
  double* __restrict z;
};

KNITMECH_VECTORISE void add_weighted(const double* weight, Components x, double by, Vector3 from, Vector3 besides,
                                     ForceArrays force, std::size_t n) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < rounded_up(n); ++i) {
    force.x[i] += weight[i] * (by * (x.x[i] - from.x) + besides.x);
    force.y[i] += weight[i] * (by * (x.y[i] - from.y) + besides.y);
    force.z[i] += weight[i] * (by * (x.z[i] - from.z) + besides.z);
  }
}

/// Forces on places of one element, summed up with what each does to the two nodes.
struct RowLoad {
  Vector3 all, on_end, turns_start, turns_end, on_bow;
};

struct Weights {
  const double *on_end, *on_start_slope, *on_end_slope, *on_bow;
};

/// One component of all sums.
struct ComponentLoad {
  double all, on_end, turns_start, turns_end, on_bow;
};

KNITMECH_VECTORISE ComponentLoad component_load(const double* force, Weights by, std::size_t n) {
  double all = 0, on_end = 0, turns_start = 0, turns_end = 0, on_bow = 0;
#pragma omp simd reduction(+ : all, on_end, turns_start, turns_end, on_bow)
  for (std::size_t i = 0; i < rounded_up(n); ++i) {
    all += force[i];
    on_end += by.on_end[i] * force[i];
    turns_start += by.on_start_slope[i] * force[i];
    turns_end += by.on_end_slope[i] * force[i];
    on_bow += by.on_bow[i] * force[i];
  }
  return {all, on_end, turns_start, turns_end, on_bow};
}

}  // namespace

void PlacedPoints::make_room(std::size_t n) {
  if (n <= x_.size()) return;
  const std::size_t room = std::max(n, 2 * x_.size());
  for (auto* values :
       {&on_end_, &on_start_slope_, &on_end_slope_, &on_bow_, &x_, &y_, &z_, &vx_, &vy_, &vz_, &fx_, &fy_, &fz_}) {
    values->resize(room);
  }
}

std::size_t PlacedPoints::add(const PlaceRow& row, const Centreline& line, const model::State& state) {
  const std::size_t first = n_;
  make_room(n_ + rounded_up(row.n) + kPointsAtOnce);
  n_ += rounded_up(row.n);
  const auto i = static_cast<std::size_t>(row.element);
  const ElementLine element = line.element(i);
  const Curve curve = element.curve();
  const Vector3 start_turning = state.angular_velocity.at(i);
  const Vector3 end_turning = state.angular_velocity.at(i + 1);
  const Curve moving{state.velocity.at(i), state.velocity.at(i + 1), cross(start_turning, curve.start_slope),
                     cross(end_turning, curve.end_slope),
                     cross(start_turning, element.start_bow) + cross(end_turning, element.end_bow)};
  place(row, Around(curve), Around(moving),
        {&on_end_[first], &on_start_slope_[first], &on_end_slope_[first], &on_bow_[first], &x_[first], &y_[first],
         &z_[first], &vx_[first], &vy_[first], &vz_[first], &fx_[first], &fy_[first], &fz_[first]});
  return first;
}

void PlacedPoints::depths_below(Vector3 place, double radii, std::size_t first, std::size_t n, double* depth) const {
  depths(place, radii, n, &x_[first], &y_[first], &z_[first], depth);
}

PlacedPoints::WeightedSum PlacedPoints::sum(std::size_t first, std::size_t n, const double* weight) const {
  return weighted_sum(weight, {&x_[first], &y_[first], &z_[first]}, {&vx_[first], &vy_[first], &vz_[first]}, n);
}

void PlacedPoints::add_forces(std::size_t first, std::size_t n, const double* weight, double by, Vector3 from,
                              Vector3 besides) {
  add_weighted(weight, {&x_[first], &y_[first], &z_[first]}, by, from, besides, {&fx_[first], &fy_[first], &fz_[first]},
               n);
}

EndLoads PlacedPoints::to_nodes(const ElementLine& element, std::size_t first, std::size_t n) const {
  const Weights by{&on_end_[first], &on_start_slope_[first], &on_end_slope_[first], &on_bow_[first]};
  const ComponentLoad x = component_load(&fx_[first], by, n);
  const ComponentLoad y = component_load(&fy_[first], by, n);
  const ComponentLoad z = component_load(&fz_[first], by, n);
  const RowLoad load{{x.all, y.all, z.all},
                     {x.on_end, y.on_end, z.on_end},
                     {x.turns_start, y.turns_start, z.turns_start},
                     {x.turns_end, y.turns_end, z.turns_end},
                     {x.on_bow, y.on_bow, z.on_bow}};
  return {load.all - load.on_end, load.on_end,
          element.length * cross(element.start_tangent, load.turns_start) + cross(element.start_bow, load.on_bow),
          element.length * cross(element.end_tangent, load.turns_end) + cross(element.end_bow, load.on_bow)};
}

}  // namespace knitmech::contact
