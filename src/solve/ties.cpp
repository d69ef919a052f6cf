#include "solve/ties.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>

#include "solve/constants.h"

namespace knitmech::solve {

namespace {

Vector3 turned(const model::State& state, std::size_t node, Vector3 arm) {
  const model::RotationArray& q = state.rotation;
  const Vector3 v{q.x[node], q.y[node], q.z[node]};
  const Vector3 twice = 2.0 * cross(v, arm);
  return arm + q.w[node] * twice + cross(v, twice);
}

model::State stress_free(const model::Model& model) {
  model::State state(model.nodes.size());
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    state.position.set(i, {model.nodes[i].x(), model.nodes[i].y(), model.nodes[i].z()});
  }
  return state;
}

std::size_t nearest_node(model::ElementPlace place) {
  return static_cast<std::size_t>(place.element) + (place.share > 0.5 ? 1 : 0);
}

Eigen::Vector3d eigen(Vector3 v) {
  return {v.x, v.y, v.z};
}

/// Gives a force on a point of a tie to the nodes.
template <class Point>
void spread(const Point& point, Vector3 force, model::NodalLoads& loads) {
  for (const std::size_t k : {0U, 1U}) {
    loads.force.add(point.node + k, point.weight[k] * force);
    loads.moment.add(point.node + k, cross(point.arm[k], force));
  }
}

}  // namespace

/// The velocities after the coming step, under the loads there are.
class Ties::Coming {
 public:
  Coming(const beam::NodalInertia& inertia, const std::vector<char>& gripped, StepLengths step, double mass_damping,
         const model::State& state, model::NodalLoads& loads)
      : inertia_(inertia),
        gripped_(gripped),
        state_(state),
        loads_(loads),
        kept_((1 - 0.5 * mass_damping * step.mean()) / (1 + 0.5 * mass_damping * step.mean())),
        gained_(step.mean() / (1 + 0.5 * mass_damping * step.mean())) {}

  void load(const Point& point, Vector3 force) { spread(point, force, loads_); }

  [[nodiscard]] Vector3 velocity(const Point& point) const {
    Vector3 velocity{0, 0, 0};
    for (const std::size_t k : {0U, 1U}) {
      const std::size_t node = point.node + k;
      const bool is_held = gripped_[node] != 0;
      const double kept = is_held ? 1 : kept_;
      const double gained = is_held ? 0 : gained_;
      const Vector3 v = kept * state_.velocity.at(node) + (gained / inertia_.mass[node]) * loads_.force.at(node);
      const Vector3 w =
          kept * state_.angular_velocity.at(node) + (gained / inertia_.rotary[node]) * loads_.moment.at(node);
      velocity = velocity + point.weight[k] * v + cross(w, point.arm[k]);
    }
    return velocity;
  }

  /// Velocity that a unit force on the point gives it.
  [[nodiscard]] Eigen::Matrix3d mobility(const Point& point) const {
    Eigen::Matrix3d mobility = Eigen::Matrix3d::Zero();
    for (const std::size_t k : {0U, 1U}) {
      const std::size_t node = point.node + k;
      if (gripped_[node] != 0) continue;
      const Eigen::Vector3d arm = eigen(point.arm[k]);
      const double by_motion = point.weight[k] * point.weight[k] / inertia_.mass[node];
      mobility += (by_motion + arm.squaredNorm() / inertia_.rotary[node]) * Eigen::Matrix3d::Identity() -
                  arm * arm.transpose() / inertia_.rotary[node];
    }
    return gained_ * mobility;
  }

 private:
  const beam::NodalInertia& inertia_;
  const std::vector<char>& gripped_;
  const model::State& state_;
  model::NodalLoads& loads_;
  double kept_, gained_;
};

Ties::Ties(const model::Model& model) : gripped_(model.nodes.size(), 0) {
  if (model.ties.empty()) return;
  for (const std::string& set : {model.test.held_set, model.test.driven_set}) {
    for (const int node : model.node_sets.at(set)) gripped_[static_cast<std::size_t>(node)] = 1;
  }
  contact::Centreline line(model);
  line.update(stress_free(model), {}, 0);
  for (const model::Tie& tie : model.ties) {
    const Vector3 between = line.point(tie.second) - line.point(tie.first);
    ties_.push_back({.first = {tie.first, nearest_node(tie.first), 0.5 * between},
                     .second = {tie.second, nearest_node(tie.second), -0.5 * between}});
  }
}

Ties::Point Ties::point_of(const contact::Centreline& line, const model::State& state, const Anchor& anchor) {
  const auto node = static_cast<std::size_t>(anchor.place.element);
  const contact::Hold hold = line.hold(anchor.place);
  const Vector3 arm = turned(state, anchor.node, anchor.arm);
  Point point{node, {hold.start, hold.end}, {hold.start_arm, hold.end_arm}, line.point(anchor.place) + arm};
  Vector3& of_node = point.arm[anchor.node - node];
  of_node = of_node + arm;
  return point;
}

void Ties::apply(const contact::Centreline& line, const beam::NodalInertia& inertia, StepLengths step,
                 double mass_damping, const model::State& state, model::NodalLoads& loads) {
  if (ties_.empty()) return;
  Coming coming(inertia, gripped_, step, mass_damping, state, loads);
  std::vector<Eigen::Matrix3d> stiffness;  // force that takes away a velocity between the points of a tie
  stiffness.reserve(ties_.size());
  largest_stretch_ = 0;
  for (Tie& tie : ties_) {
    tie.now_first = point_of(line, state, tie.first);
    tie.now_second = point_of(line, state, tie.second);
    largest_stretch_ = std::max(largest_stretch_, length(tie.now_second.position - tie.now_first.position));
    stiffness.emplace_back((coming.mobility(tie.now_first) + coming.mobility(tie.now_second)).inverse());
    coming.load(tie.now_first, tie.force);
    coming.load(tie.now_second, -1.0 * tie.force);
  }
  for (int turn = 0; turn < kTieTurns; ++turn) {
    for (std::size_t k = 0; k < ties_.size(); ++k) {
      Tie& tie = ties_[k];
      const Vector3 apart = tie.now_second.position - tie.now_first.position;
      const Vector3 parting =
          coming.velocity(tie.now_second) - coming.velocity(tie.now_first) + (kTieRecovery / step.after) * apart;
      const Eigen::Vector3d more = stiffness[k] * eigen(parting);
      const Vector3 force{more.x(), more.y(), more.z()};
      coming.load(tie.now_first, force);
      coming.load(tie.now_second, -1.0 * force);
      tie.force = tie.force + force;
    }
  }
}

void Ties::remove(std::size_t element) {
  const auto is_on = [&](const Anchor& anchor) { return static_cast<std::size_t>(anchor.place.element) == element; };
  std::erase_if(ties_, [&](const Tie& tie) { return is_on(tie.first) || is_on(tie.second); });
}

void Ties::add_last_forces(model::NodalLoads& loads) const {
  for (const Tie& tie : ties_) {
    spread(tie.now_first, tie.force, loads);
    spread(tie.now_second, -1.0 * tie.force, loads);
  }
}

void Ties::set_results(model::Frame& frame) const {
  model::NodalLoads loads(frame.points.size());
  add_last_forces(loads);
  frame.tie_force.clear();
  for (std::size_t i = 0; i < frame.points.size(); ++i) frame.tie_force.push_back(eigen(loads.force.at(i)));
}

}  // namespace knitmech::solve
