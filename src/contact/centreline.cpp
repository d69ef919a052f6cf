#include "contact/centreline.h"

#include <algorithm>
#include <cmath>

#include "base/vectorise.h"

namespace knitmech::contact {

namespace {

/// t_i = R_i t_i0; returns the largest distance that a node has moved plus `reach` times the turn of its tangent.
struct NodeArrays {
  const double *x, *y, *z, *qw, *qx, *qy, *qz, *sx, *sy, *sz;
  double* __restrict tx, * __restrict ty, * __restrict tz;
  double* __restrict x0, * __restrict y0, * __restrict z0;
};

KNITMECH_VECTORISE double move_nodes(const NodeArrays a, double reach, std::size_t n) {
  double largest = 0;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3 t{a.sx[i], a.sy[i], a.sz[i]};
    const Vector3 q{a.qx[i], a.qy[i], a.qz[i]};
    const Vector3 c = 2.0 * cross(q, t);
    const Vector3 turned = t + a.qw[i] * c + cross(q, c);
    const double moved = length(Vector3{a.x[i] - a.x0[i], a.y[i] - a.y0[i], a.z[i] - a.z0[i]}) +
                         reach * length(Vector3{turned.x - a.tx[i], turned.y - a.ty[i], turned.z - a.tz[i]});
    largest = largest > moved ? largest : moved;
    a.tx[i] = turned.x;
    a.ty[i] = turned.y;
    a.tz[i] = turned.z;
    a.x0[i] = a.x[i];
    a.y0[i] = a.y[i];
    a.z0[i] = a.z[i];
  }
  return largest;
}

/// One component of one inner point of every element: its position and its derivative by the arc length.
struct InnerPoint {
  const double *node, *tangent, *length;
  double* __restrict position, * __restrict direction;  ///< of that point of the first element
  std::size_t stride;
};

KNITMECH_VECTORISE void place_inner_points(const InnerPoint a, HermiteWeights value, HermiteWeights slope,
                                           std::size_t n_elements) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < n_elements; ++i) {
    const double size = a.length[i];
    const double inverse = size > 0 ? 1 / size : 0.0;
    a.position[i * a.stride] = value.start * a.node[i] + value.end * a.node[i + 1] +
                               size * (value.start_slope * a.tangent[i] + value.end_slope * a.tangent[i + 1]);
    a.direction[i * a.stride] = inverse * (slope.start * a.node[i] + slope.end * a.node[i + 1]) +
                                slope.start_slope * a.tangent[i] + slope.end_slope * a.tangent[i + 1];
  }
}

}  // namespace

Centreline::Centreline(const model::Model& model, const ContactElements& elements)
    : smooth_(elements.is_smooth()),
      pieces_per_element_(static_cast<std::size_t>(elements.pieces_per_element)),
      element_length_(model.nodes.size(), 0.0),
      stress_free_tangent_(model.nodes.size()),
      tangent_(model.nodes.size()),
      node_position_(model.nodes.size()),
      position_(elements.n_nodes()),
      direction_(elements.n_nodes()) {
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    stress_free_tangent_.set(i, {model.tangents[i].x(), model.tangents[i].y(), model.tangents[i].z()});
    element_length_[i] = elements.pieces_per_element * elements.curve_length[i * pieces_per_element_];
  }
  if (smooth_) reach_of_turn_ = *std::max_element(element_length_.begin(), element_length_.end()) / 3;
}

double Centreline::update(const model::State& state) {
  const model::VectorArray& x = state.position;
  const model::RotationArray& q = state.rotation;
  const double moved = move_nodes(
      {x.x.data(), x.y.data(), x.z.data(), q.w.data(), q.x.data(), q.y.data(), q.z.data(),
       stress_free_tangent_.x.data(), stress_free_tangent_.y.data(), stress_free_tangent_.z.data(), tangent_.x.data(),
       tangent_.y.data(), tangent_.z.data(), node_position_.x.data(), node_position_.y.data(), node_position_.z.data()},
      reach_of_turn_, x.size());
  update_inner_points(state);
  return moved;
}

void Centreline::update_inner_points(const model::State& state) {
  const std::size_t m = pieces_per_element_;
  const std::size_t n = state.position.size();
  for (std::size_t k = 0; k < m; ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(m);
    const auto place = [&](const std::vector<double>& node, const std::vector<double>& tangent,
                           std::vector<double>& position, std::vector<double>& direction) {
      place_inner_points(
          {node.data(), tangent.data(), element_length_.data(), position.data() + k, direction.data() + k, m},
          hermite(s), hermite_slope(s), n - 1);
    };
    place(state.position.x, tangent_.x, position_.x, direction_.x);
    place(state.position.y, tangent_.y, position_.y, direction_.y);
    place(state.position.z, tangent_.z, position_.z, direction_.z);
  }
  position_.set(m * (n - 1), state.position.at(n - 1));
  direction_.set(m * (n - 1), tangent_.at(n - 1));
}

Curve Centreline::curve(const ContactElements& elements, std::size_t piece) const {
  const Vector3 start = position_.at(piece);
  const Vector3 end = position_.at(piece + 1);
  if (!smooth_) return {start, end, end - start, end - start};
  const double length = elements.curve_length[piece];
  return {start, end, length * direction_.at(piece), length * direction_.at(piece + 1)};
}

Vector3 Centreline::velocity(const ContactElements& elements, const model::State& state, std::int32_t piece,
                             double place) const {
  const std::size_t i = elements.element_of(piece);
  const double s = elements.place_on_element(piece, place);
  const Vector3 start = state.velocity.at(i);
  const Vector3 end = state.velocity.at(i + 1);
  if (!smooth_) return (1 - s) * start + s * end;
  const HermiteWeights weights = hermite(s);
  const double size = element_length_[i];
  return weights.start * start + (size * weights.start_slope) * cross(state.angular_velocity.at(i), tangent_.at(i)) +
         weights.end * end + (size * weights.end_slope) * cross(state.angular_velocity.at(i + 1), tangent_.at(i + 1));
}

void Centreline::spread(const ContactElements& elements, std::int32_t piece, double place, Vector3 force,
                        model::NodalLoads& loads) const {
  const std::size_t i = elements.element_of(piece);
  const double s = elements.place_on_element(piece, place);
  if (!smooth_) {
    loads.force.add(i, (1 - s) * force);
    loads.force.add(i + 1, s * force);
    return;
  }
  const HermiteWeights weights = hermite(s);
  const double size = element_length_[i];
  loads.force.add(i, weights.start * force);
  loads.force.add(i + 1, weights.end * force);
  loads.moment.add(i, (size * weights.start_slope) * cross(tangent_.at(i), force));
  loads.moment.add(i + 1, (size * weights.end_slope) * cross(tangent_.at(i + 1), force));
}

}  // namespace knitmech::contact
