#include "solve/selective_mass.h"

#include <algorithm>
#include <array>

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

/// Chains that are worked on in turns [-]: what follows from node to node within one has to be waited for, that of
/// others has not.
constexpr std::size_t kChainsAtOnce = 4;

struct FactorView {
  const double *forward, *backward, *inverse_pivot;
};

struct ForceView {
  double* __restrict x;
  double* __restrict y;
  double* __restrict z;
};

/// y_i = F_i + forward_(i-1) y_(i-1) in three directions, of k chains with n nodes.
template <std::size_t k>
void eliminate(const std::array<std::size_t, k>& first, std::size_t n, const FactorView across, const FactorView along,
               const ForceView f) {
  std::array<double, k> x{}, y{}, z{};
  for (std::size_t c = 0; c < k; ++c) {
    x[c] = f.x[first[c]];
    y[c] = f.y[first[c]];
    z[c] = f.z[first[c]];
  }
  for (std::size_t i = 1; i < n; ++i) {
    for (std::size_t c = 0; c < k; ++c) {
      const std::size_t at = first[c] + i;
      f.x[at] = x[c] = f.x[at] + across.forward[at - 1] * x[c];
      f.y[at] = y[c] = f.y[at] + along.forward[at - 1] * y[c];
      f.z[at] = z[c] = f.z[at] + across.forward[at - 1] * z[c];
    }
  }
}

/// a_i = y_i / pivot_i + backward_i a_(i+1), and the values become m a.
template <std::size_t k>
void substitute(const std::array<std::size_t, k>& first, std::size_t n, const FactorView across, const FactorView along,
                const double* mass, const ForceView f) {
  std::array<double, k> x{}, y{}, z{};
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t c = 0; c < k; ++c) {
      const std::size_t at = first[c] + i;
      x[c] = f.x[at] * across.inverse_pivot[at] + across.backward[at] * x[c];
      y[c] = f.y[at] * along.inverse_pivot[at] + along.backward[at] * y[c];
      z[c] = f.z[at] * across.inverse_pivot[at] + across.backward[at] * z[c];
      f.x[at] = mass[at] * x[c];
      f.y[at] = mass[at] * y[c];
      f.z[at] = mass[at] * z[c];
    }
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
      chains_(chains_of(inertia.relative_mass)),
      along_(inertia, given.along),
      across_(inertia, given.across),
      free_(inertia, std::vector<char>(inertia.mass.size())) {}

std::vector<SelectiveMass::Chain> SelectiveMass::chains_of(const std::vector<double>& relative_mass) {
  std::vector<Chain> chains;
  for (std::size_t i = 0; i < relative_mass.size(); ++i) {
    if (relative_mass[i] == 0) continue;
    if (i == 0 || relative_mass[i - 1] == 0) chains.push_back({i, 1});
    ++chains.back().n;
  }
  return chains;
}

template <std::size_t k>
void SelectiveMass::share_in(const Chain* chains, model::NodalLoads& loads) const {
  std::array<std::size_t, k> first{};
  for (std::size_t c = 0; c < k; ++c) first[c] = chains[c].first;
  const auto view = [](const Factors& of) {
    return FactorView{of.forward.data(), of.backward.data(), of.inverse_pivot.data()};
  };
  const ForceView forces{loads.force.x.data(), loads.force.y.data(), loads.force.z.data()};
  eliminate(first, chains[0].n, view(across_), view(along_), forces);
  substitute(first, chains[0].n, view(across_), view(along_), mass_.data(), forces);
}

void SelectiveMass::share(model::NodalLoads& loads, const base::ThreadTeam& team) const {
  team.for_ranges(chains_.size(), kChainsAtOnce, [&](std::size_t begin, std::size_t end) {
    while (begin < end) {
      const Chain* const chains = &chains_[begin];
      const auto is_alike = [&](const Chain& chain) { return chain.n == chains->n; };
      if (begin + kChainsAtOnce <= end && std::all_of(chains, chains + kChainsAtOnce, is_alike)) {
        share_in<kChainsAtOnce>(chains, loads);
        begin += kChainsAtOnce;
      } else {
        share_in<1>(chains, loads);
        ++begin;
      }
    }
  });
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
