#include "contact/placed_points.h"

#include <algorithm>

#include "base/vectorise.h"

namespace knitmech::contact {

namespace {

/// One component of a block's points: value at the start, and what the weights multiply.
struct Component {
  double start, along, start_slope, end_slope, bow;
};

KNITMECH_VECTORISE void interpolate(std::size_t n, const Component& by, const double* on_end,
                                    const double* on_start_slope, const double* on_end_slope, const double* on_bow,
                                    double* values) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = by.start + on_end[i] * by.along + on_start_slope[i] * by.start_slope + on_end_slope[i] * by.end_slope +
                on_bow[i] * by.bow;
  }
}

double x_of(Vector3 v) {
  return v.x;
}
double y_of(Vector3 v) {
  return v.y;
}
double z_of(Vector3 v) {
  return v.z;
}

}  // namespace

void PlacedPoints::clear() {
  blocks_.clear();
  in_use_.clear();
  element_.clear();
  for (auto* values : {&share_, &on_end_, &on_start_slope_, &on_end_slope_, &on_bow_, &x_, &y_, &z_, &vx_, &vy_, &vz_,
                       &fx_, &fy_, &fz_}) {
    values->clear();
  }
}

std::size_t PlacedPoints::add(std::int32_t element, const std::vector<double>& shares) {
  const std::size_t first = size();
  blocks_.push_back({element, first, shares.size()});
  for (const double share : shares) {
    const HermiteWeights weights = hermite(share);
    element_.push_back(element);
    share_.push_back(share);
    on_end_.push_back(weights.end);
    on_start_slope_.push_back(weights.start_slope);
    on_end_slope_.push_back(weights.end_slope);
    on_bow_.push_back(weights.bow);
  }
  for (auto* values : {&x_, &y_, &z_, &vx_, &vy_, &vz_, &fx_, &fy_, &fz_}) values->resize(first + shares.size());
  return first;
}

void PlacedPoints::update(Block& block, const Centreline& line, const model::State& state) {
  const auto i = static_cast<std::size_t>(block.element);
  const ElementLine element = line.element(i);
  const Curve curve = element.curve();
  const Vector3 start_turning = state.angular_velocity.at(i);
  const Vector3 end_turning = state.angular_velocity.at(i + 1);
  const Curve moving{state.velocity.at(i), state.velocity.at(i + 1), cross(start_turning, curve.start_slope),
                     cross(end_turning, curve.end_slope),
                     cross(start_turning, element.start_bow) + cross(end_turning, element.end_bow)};
  const std::size_t at = block.first;
  const auto fill = [&](const Curve& of, double (*component)(Vector3), std::vector<double>& values) {
    const double start = component(of.start);
    interpolate(
        block.count,
        {start, component(of.end) - start, component(of.start_slope), component(of.end_slope), component(of.bow)},
        &on_end_[at], &on_start_slope_[at], &on_end_slope_[at], &on_bow_[at], &values[at]);
  };
  fill(curve, x_of, x_);
  fill(curve, y_of, y_);
  fill(curve, z_of, z_);
  fill(moving, x_of, vx_);
  fill(moving, y_of, vy_);
  fill(moving, z_of, vz_);
  for (auto* values : {&fx_, &fy_, &fz_})
    std::fill_n(values->begin() + static_cast<std::ptrdiff_t>(at), block.count, 0.0);
  block.step = step_;
}

void PlacedPoints::give_forces(const Centreline& line, model::NodalLoads& loads) const {
  for (const std::size_t b : in_use_) {
    const Block& block = blocks_[b];
    Vector3 all{}, on_end{}, turns_start{}, turns_end{}, on_bow{};
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      const Vector3 force{fx_[p], fy_[p], fz_[p]};
      all = all + force;
      on_end = on_end + on_end_[p] * force;
      turns_start = turns_start + on_start_slope_[p] * force;
      turns_end = turns_end + on_end_slope_[p] * force;
      on_bow = on_bow + on_bow_[p] * force;
    }
    if (dot(all, all) + dot(turns_start, turns_start) + dot(turns_end, turns_end) == 0) continue;
    const auto i = static_cast<std::size_t>(block.element);
    const ElementLine element = line.element(i);
    loads.force.add(i, all - on_end);
    loads.force.add(i + 1, on_end);
    loads.moment.add(i, element.length * cross(element.start_tangent, turns_start) + cross(element.start_bow, on_bow));
    loads.moment.add(i + 1, element.length * cross(element.end_tangent, turns_end) + cross(element.end_bow, on_bow));
  }
}

}  // namespace knitmech::contact
