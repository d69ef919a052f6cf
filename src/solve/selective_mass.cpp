#include "solve/selective_mass.h"

namespace knitmech::solve {

namespace {

/// What a node feels of a neighbour that it drags along through b, the neighbour having the inertia m.
double in_series(double b, double m) {
  return b > 0 ? b * m / (b + m) : 0;
}

std::vector<double> felt_masses(const beam::NodalInertia& inertia) {
  std::vector<double> felt = inertia.mass;
  if (inertia.relative_mass.empty()) return felt;
  const std::vector<double>& b = inertia.relative_mass;
  const std::size_t n = felt.size();
  double before = 0;
  double behind = 0;
  for (std::size_t i = 1; i < n; ++i) {
    before = in_series(b[i - 1], inertia.mass[i - 1] + before);
    felt[i] += before;
  }
  for (std::size_t i = n - 1; i-- > 0;) {
    behind = in_series(b[i], inertia.mass[i + 1] + behind);
    felt[i] += behind;
  }
  return felt;
}

/// y_i = F_i + forward_(i-1) y_(i-1) in three directions. They are independent chains of operations, of which a
/// processor works on several at a time; each hands its last value on in a register.
void eliminate(const double* across, const double* along, double* __restrict x, double* __restrict y,
               double* __restrict z, std::size_t first, std::size_t last) {
  double before_x = x[first];
  double before_y = y[first];
  double before_z = z[first];
  for (std::size_t i = first + 1; i < last; ++i) {
    x[i] = before_x = x[i] + across[i - 1] * before_x;
    y[i] = before_y = y[i] + along[i - 1] * before_y;
    z[i] = before_z = z[i] + across[i - 1] * before_z;
  }
}

struct BackwardView {
  const double *backward, *inverse_pivot;
};

/// a_i = y_i / pivot_i + backward_i a_(i+1), and the values become m a.
void substitute(const BackwardView across, const BackwardView along, const double* mass, double* __restrict x,
                double* __restrict y, double* __restrict z, std::size_t first, std::size_t last) {
  double behind_x = 0;
  double behind_y = 0;
  double behind_z = 0;
  for (std::size_t i = last; i-- > first;) {
    behind_x = x[i] * across.inverse_pivot[i] + across.backward[i] * behind_x;
    behind_y = y[i] * along.inverse_pivot[i] + along.backward[i] * behind_y;
    behind_z = z[i] * across.inverse_pivot[i] + across.backward[i] * behind_z;
    x[i] = mass[i] * behind_x;
    y[i] = mass[i] * behind_y;
    z[i] = mass[i] * behind_z;
  }
}

}  // namespace

GivenMotion GivenMotion::by_grips(const model::Model& model) {
  GivenMotion given{std::vector<char>(model.nodes.size()), std::vector<char>(model.nodes.size())};
  for (const int node : model.node_sets.at(model.test.held_set)) {
    given.along[static_cast<std::size_t>(node)] = given.across[static_cast<std::size_t>(node)] = 1;
  }
  for (const int node : model.node_sets.at(model.test.driven_set)) {
    given.along[static_cast<std::size_t>(node)] = 1;
    if (model.test.grips == model::Grips::clamped) given.across[static_cast<std::size_t>(node)] = 1;
  }
  return given;
}

SelectiveMass::Factors::Factors(const beam::NodalInertia& inertia, const std::vector<char>& given) {
  if (inertia.relative_mass.empty()) return;
  const std::vector<double>& b = inertia.relative_mass;
  const std::size_t n = inertia.mass.size();
  forward.assign(n, 0.0);
  backward.assign(n, 0.0);
  inverse_pivot.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const bool follows_free = i > 0 && given[i - 1] == 0;
    const double before = i == 0 ? 0 : b[i - 1];
    const double eliminated = follows_free ? before * forward[i - 1] : 0;
    const double pivot = given[i] != 0 ? inertia.mass[i] : inertia.mass[i] + before + b[i] - eliminated;
    inverse_pivot[i] = 1 / pivot;
    forward[i] = b[i] / pivot;
    backward[i] = given[i] != 0 ? 0 : b[i] / pivot;
  }
  for (std::size_t i = 1; i < n; ++i) {
    if (given[i] != 0) forward[i - 1] = 0;  // only now: the pivots needed it
  }
}

void SelectiveMass::Factors::solve(double* values, std::size_t n) const {
  for (std::size_t i = 1; i < n; ++i) values[i] += forward[i - 1] * values[i - 1];
  double next = 0;
  for (std::size_t i = n; i-- > 0;) {
    next = values[i] * inverse_pivot[i] + backward[i] * next;
    values[i] = next;
  }
}

SelectiveMass::SelectiveMass(const beam::NodalInertia& inertia, const GivenMotion& given)
    : mass_(inertia.mass),
      relative_(inertia.relative_mass),
      felt_(felt_masses(inertia)),
      along_(inertia, given.along),
      across_(inertia, given.across),
      free_(inertia, std::vector<char>(inertia.mass.size())) {}

void SelectiveMass::share(model::NodalLoads& loads, std::size_t first, std::size_t last) const {
  if (relative_.empty()) return;
  model::VectorArray& f = loads.force;
  eliminate(across_.forward.data(), along_.forward.data(), f.x.data(), f.y.data(), f.z.data(), first, last);
  const auto view = [](const Factors& of) { return BackwardView{of.backward.data(), of.inverse_pivot.data()}; };
  substitute(view(across_), view(along_), mass_.data(), f.x.data(), f.y.data(), f.z.data(), first, last);
}

double SelectiveMass::from_neighbours(std::size_t node, const std::vector<double>& accelerating) const {
  if (relative_.empty()) return 0;
  const auto acceleration = [&](std::size_t i) { return accelerating[i] / mass_[i]; };
  double force = 0;
  if (relative_[node] > 0) force += relative_[node] * (acceleration(node) - acceleration(node + 1));
  if (node > 0 && relative_[node - 1] > 0) {
    force += relative_[node - 1] * (acceleration(node) - acceleration(node - 1));
  }
  return force;
}

void SelectiveMass::accelerate_free(double* component) const {
  if (!relative_.empty()) return free_.solve(component, mass_.size());
  for (std::size_t i = 0; i < mass_.size(); ++i) component[i] /= mass_[i];
}

}  // namespace knitmech::solve
