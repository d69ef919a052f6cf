#include "contact/centreline.h"

#include <algorithm>
#include <cmath>

#include "base/blocks.h"
#include "base/vectorise.h"

namespace knitmech::contact {

namespace {

Vector3 vector(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// R v, R given by its quaternion w + q.
KNITMECH_INLINE Vector3 image(double w, Vector3 q, Vector3 v) {
  const Vector3 c = 2.0 * cross(q, v);
  return v + w * c + cross(q, c);
}

/// A vector of every node that turns with it.
struct Turning {
  const double *x, *y, *z;                                  ///< stress-free
  double* __restrict tx, * __restrict ty, * __restrict tz;  ///< now
};

/// \return square of its change [mm^2]
KNITMECH_INLINE double turn_one(double w, Vector3 q, const Turning& v, std::size_t i) {
  const Vector3 t = image(w, q, {v.x[i], v.y[i], v.z[i]});
  const Vector3 change{t.x - v.tx[i], t.y - v.ty[i], t.z - v.tz[i]};
  v.tx[i] = t.x;
  v.ty[i] = t.y;
  v.tz[i] = t.z;
  return dot(change, change);
}

/// Adds to the motion of the nodes what the line moves by their turning.
/// \param reach what it moves per change of a tangent at most [mm]
KNITMECH_VECTORISE void turn_all(const model::RotationArray& rotation, Turning tangent, Turning bow_after,
                                 Turning bow_before, double reach, double* __restrict moved, double* __restrict turned,
                                 std::size_t begin, std::size_t end) {
  const double* w = rotation.w.data();
  const double* qx = rotation.x.data();
  const double* qy = rotation.y.data();
  const double* qz = rotation.z.data();
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    const Vector3 q{qx[i], qy[i], qz[i]};
    const double turn = turn_one(w[i], q, tangent, i);
    const double after = turn_one(w[i], q, bow_after, i);
    const double before = turn_one(w[i], q, bow_before, i);
    turned[i] = reach * std::sqrt(turn) + 2 * std::sqrt(after > before ? after : before);
    moved[i] += turned[i];
  }
}

/// \param from entry of the first node
Turning turning(const model::VectorArray& stress_free, std::size_t from, model::VectorArray& now) {
  return {&stress_free.x[from], &stress_free.y[from], &stress_free.z[from], now.x.data(), now.y.data(), now.z.data()};
}

struct NodeArrays {
  const double *x, *y, *z;
  double* __restrict x0, * __restrict y0, * __restrict z0;
  double* __restrict moved;
};

/// Takes over positions. \param shift, stretch displacement along y that is not counted: shift [mm] + stretch [-] y
KNITMECH_VECTORISE void move_nodes(const NodeArrays a, double shift, double stretch, std::size_t begin,
                                   std::size_t end) {
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    const double dx = a.x[i] - a.x0[i];
    const double dy = a.y[i] - a.y0[i] - shift - stretch * a.y[i];
    const double dz = a.z[i] - a.z0[i];
    a.moved[i] = std::sqrt(dx * dx + dy * dy + dz * dz);
    a.x0[i] = a.x[i];
    a.y0[i] = a.y[i];
    a.z0[i] = a.z[i];
  }
}

}  // namespace

Centreline::Centreline(const model::Model& model)
    : smooth_(model.centreline == model::Centreline::smooth),
      length_(make_yarn_elements(model).length),
      stress_free_tangent_(model.nodes.size()),
      stress_free_bow_(model.nodes.size() + 1),
      tangent_(model.nodes.size()),
      bow_after_(model.nodes.size()),
      bow_before_(model.nodes.size()),
      node_position_(model.nodes.size()),
      moved_(model.nodes.size(), 0.0),
      turned_(model.nodes.size(), 0.0) {
  if (smooth_) set_stress_free(model);
}

void Centreline::set_stress_free(const model::Model& model) {
  for (std::size_t i = 0; i < model.nodes.size(); ++i) stress_free_tangent_.set(i, vector(model.tangents[i]));
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const double size = length_[i];
    if (size == 0) continue;
    longest_third_ = std::max(longest_third_, size / 3);
    if (model.middles.empty()) continue;
    const Curve cubic{vector(model.nodes[i]), vector(model.nodes[i + 1]), size * stress_free_tangent_.at(i),
                      size * stress_free_tangent_.at(i + 1)};
    const Vector3 half = 0.5 * (vector(model.middles[i]) - combine(cubic, hermite(0.5)));
    stress_free_bow_.set(i + 1, half);
    largest_bow_ = std::max(largest_bow_, 2 * knitmech::length(half));
  }
}

void Centreline::update(const model::State& state, CommonMotion common, double step, const base::ThreadTeam& team) {
  const model::VectorArray& x = state.position;
  const std::size_t n = x.size();
  const NodeArrays nodes{
      x.x.data(),   x.y.data(), x.z.data(), node_position_.x.data(), node_position_.y.data(), node_position_.z.data(),
      moved_.data()};
  const double shift = common.start * step;
  const double stretch = common.rate * step;
  team.for_ranges(n, base::kBlock, [&](std::size_t begin, std::size_t end) {
    move_nodes(nodes, shift, stretch, begin, end);
    if (!smooth_) return;
    turn_all(state.rotation, turning(stress_free_tangent_, 0, tangent_), turning(stress_free_bow_, 1, bow_after_),
             turning(stress_free_bow_, 0, bow_before_), longest_third_, moved_.data(), turned_.data(), begin, end);
  });
}

model::VectorArray Centreline::piece_positions(const ContactElements& pieces) const {
  if (!smooth_) return node_position_;
  model::VectorArray positions(pieces.n_nodes());
  const int m = pieces.pieces_per_element;
  for (std::size_t i = 0; i < length_.size(); ++i) {
    positions.set(i * static_cast<std::size_t>(m), node_position_.at(i));
    if (length_[i] == 0) continue;
    const Curve whole = curve(i);
    for (int k = 1; k < m; ++k) {
      const Vector3 position = combine(whole, hermite(static_cast<double>(k) / m));
      positions.set(i * static_cast<std::size_t>(m) + static_cast<std::size_t>(k), position);
    }
  }
  return positions;
}

Curve Centreline::piece_curve(const ContactElements& pieces, std::int32_t piece) const {
  const auto element = static_cast<std::size_t>(pieces.element_of(piece));
  if (!smooth_) {
    const Vector3 start = node_position_.at(element);
    const Vector3 end = node_position_.at(element + 1);
    return {start, end, end - start, end - start};
  }
  const Curve whole = curve(element);
  return part_of(whole, pieces.place_on_element(piece, 0), pieces.place_on_element(piece, 1));
}

}  // namespace knitmech::contact
