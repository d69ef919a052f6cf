// What the solver reports: a row of the history, a frame.

#include <algorithm>
#include <limits>

#include "beam/section_results.h"
#include "solve/explicit_solver.h"

namespace knitmech::solve {

namespace {

/// Tells the nodes whose extent along x is the width of the fabric: those of the middle course; where the courses are
/// not known, those that lie in the middle third of its height before the test.
class Middle {
 public:
  explicit Middle(const model::Model& model) : model_(model) {
    course_ = (1 + *std::max_element(model.course.begin(), model.course.end())) / 2;
    for (const Eigen::Vector3d& node : model.nodes) {
      lowest_ = std::min(lowest_, node.y());
      highest_ = std::max(highest_, node.y());
    }
  }

  [[nodiscard]] bool holds(std::size_t node) const {
    if (model_.has_stitches) return model_.course[node] == course_ && model_.wale[node] != knit::kNoWale;
    const double third = (highest_ - lowest_) / 3;
    const double y = model_.nodes[node].y();
    return y >= lowest_ + third && y <= highest_ - third;
  }

 private:
  const model::Model& model_;
  int course_ = 0;
  double lowest_ = std::numeric_limits<double>::max();
  double highest_ = std::numeric_limits<double>::lowest();
};

}  // namespace

double ExplicitSolver::width() const {
  const Middle middle(model_);
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (std::size_t node = 0; node < model_.nodes.size(); ++node) {
    if (!middle.holds(node)) continue;
    low = std::min(low, state_.position.x[node]);
    high = std::max(high, state_.position.x[node]);
  }
  return high - low;
}

double ExplicitSolver::internal_energy() const {
  return beam::strain_energy(elements_, state_, team_) + nonlinear_.energy_beyond_secants(elements_, state_, team_) +
         folds_.energy();
}

double ExplicitSolver::stretch_energy() const {
  return beam::stretch_energy(elements_, state_, team_) + nonlinear_.energy_beyond_secants(elements_, state_, team_);
}

double ExplicitSolver::kinetic_energy() const {
  if (steps_ == 0) return 0;
  model::NodalLoads free_loads = loads_;
  ties_.add_last_forces(free_loads);
  grips_.clear_loads(free_loads);  // what the fabric does to a grip does not accelerate it
  masses_.share(free_loads, team_);
  return solve::kinetic_energy(inertia_, free_loads, step_, state_, team_);
}

model::HistoryRow ExplicitSolver::history() {
  evaluate();
  model::HistoryRow row;
  row.time = state_.time;
  row.displacement = displacement();
  row.strain = strain();
  if (!grip_forces_.empty()) {
    const ForceWindow::Forces forces = grip_forces_.at(row.displacement);
    row.force_top = forces.top;
    row.force_bottom = forces.bottom;
  }
  grip_forces_ = {};
  row.external_work = grips_.work() + pull_.work();
  row.internal_energy = internal_energy();
  row.stretch_energy = stretch_energy();
  row.kinetic_energy = kinetic_energy();
  row.contact_energy = contact_.energy();
  row.friction_loss = earlier_.friction_loss + contact_.friction_loss();
  row.damping_loss = beam::damping_loss(work_) + mass_damping_loss_ + pull_.damping_loss();
  row.break_loss = break_loss_;
  row.width = width();
  contact_.check_crossings(team_);
  const std::vector<contact::ContactPoint> points = contact_.points();
  row.contacts = static_cast<int>(points.size());
  for (const contact::ContactPoint& point : points) {
    row.normal_force += point.load;
    row.largest_elastic_slip = std::max(row.largest_elastic_slip, length(point.stick.elastic_slip));
  }
  row.largest_penetration = contact_.largest_penetration();
  row.step = step_in_use_;
  return row;
}

model::Frame ExplicitSolver::frame(int index, const model::HistoryRow& row) const {
  model::Frame frame;
  frame.index = index;
  frame.history = row;
  const std::size_t n = state_.position.size();
  frame.points.resize(n);
  frame.rotations.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    frame.points[i] = {state_.position.x[i], state_.position.y[i], state_.position.z[i]};
    frame.rotations[i] = {state_.rotation.w[i], state_.rotation.x[i], state_.rotation.y[i], state_.rotation.z[i]};
  }
  beam::set_section_results(elements_, state_, frame);
  nonlinear_.correct_stretch_energy(elements_, frame);
  contact_.set_contact_results(frame);
  pieces_.name_whole_yarns(frame.contacts);
  frame.broken = pieces_.elements();
  ties_.set_results(frame);
  return frame;
}

}  // namespace knitmech::solve
