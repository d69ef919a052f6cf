#include "solve/integrate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/blocks.h"
#include "base/vectorise.h"

namespace knitmech::solve {

namespace {

/// Read-only view of vectors.
struct Vectors {
  const double *x, *y, *z;

  explicit Vectors(const model::VectorArray& of) : x(of.x.data()), y(of.y.data()), z(of.z.data()) {}
  [[nodiscard]] KNITMECH_INLINE Vector3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Vectors that no other array of a loop overlaps.
struct OwnVectors {
  double* __restrict x;
  double* __restrict y;
  double* __restrict z;

  explicit OwnVectors(model::VectorArray& of) : x(of.x.data()), y(of.y.data()), z(of.z.data()) {}
  [[nodiscard]] KNITMECH_INLINE Vector3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  KNITMECH_INLINE void set(std::size_t i, Vector3 v) const {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};

struct OwnRotations {
  double* __restrict w;
  double* __restrict x;
  double* __restrict y;
  double* __restrict z;

  explicit OwnRotations(model::RotationArray& of) : w(of.w.data()), x(of.x.data()), y(of.y.data()), z(of.z.data()) {}

  /// q <- exp(step w) q. The half angle of one step is small: sine and cosine by their series, exact to rounding below
  /// 0.1, then one Newton step of the normalisation, which also keeps rounding from adding up.
  KNITMECH_INLINE void turn(std::size_t i, Vector3 velocity, double step) const {
    const Vector3 half = (0.5 * step) * velocity;
    const double h2 = dot(half, half);
    const double cosine = 1 - h2 * (1.0 / 2) * (1 - h2 * (1.0 / 12) * (1 - h2 * (1.0 / 30)));
    const double sine = 1 - h2 * (1.0 / 6) * (1 - h2 * (1.0 / 20) * (1 - h2 * (1.0 / 42)));
    const Vector3 s = sine * half;
    const Vector3 q{x[i], y[i], z[i]};
    const double turned_w = cosine * w[i] - dot(s, q);
    const Vector3 turned = cosine * q + w[i] * s + cross(s, q);
    const double unit = 1.5 - 0.5 * (turned_w * turned_w + dot(turned, turned));
    w[i] = unit * turned_w;
    x[i] = unit * turned.x;
    y[i] = unit * turned.y;
    z[i] = unit * turned.z;
  }
};

/// What moves the nodes.
struct Causes {
  const double *mass, *rotary;
  Vectors force, moment;

  Causes(const beam::NodalInertia& inertia, const model::NodalLoads& loads)
      : mass(inertia.mass.data()), rotary(inertia.rotary.data()), force(loads.force), moment(loads.moment) {}
};

struct Moving {
  OwnVectors position, velocity, angular_velocity;
  OwnRotations rotation;

  explicit Moving(model::State& state)
      : position(state.position),
        velocity(state.velocity),
        angular_velocity(state.angular_velocity),
        rotation(state.rotation) {}
};

/// v+ = kept v- + gained F / m, see integrate().
struct Damped {
  double kept;    ///< [-]
  double gained;  ///< [s]

  Damped(StepLengths step, double mass_damping) {
    const double damping = 0.5 * mass_damping * step.mean();
    kept = (1 - damping) / (1 + damping);
    gained = step.mean() / (1 + damping);
  }
};

/// In one pass over the memory, which is what takes the time in a large fabric.
KNITMECH_VECTORISE void advance(const Causes by, const Moving nodes, const Damped damped, double step,
                                std::size_t begin, std::size_t end) {
#pragma GCC ivdep
  for (std::size_t i = begin; i < end; ++i) {
    const Vector3 v = damped.kept * nodes.velocity.at(i) + (damped.gained / by.mass[i]) * by.force.at(i);
    const Vector3 w = damped.kept * nodes.angular_velocity.at(i) + (damped.gained / by.rotary[i]) * by.moment.at(i);
    nodes.velocity.set(i, v);
    nodes.angular_velocity.set(i, w);
    nodes.position.set(i, nodes.position.at(i) + step * v);
    nodes.rotation.turn(i, w, step);
  }
}

struct Velocities {
  Vectors linear, angular;
  explicit Velocities(const model::State& state) : linear(state.velocity), angular(state.angular_velocity) {}
};

/// Kinetic energy of n nodes [mJ] at the velocities  share v- + time F / m.
KNITMECH_VECTORISE double energy_pass(const Causes by, const Velocities before, double share, double time,
                                      std::size_t begin, std::size_t n) {
  std::array<double, base::kBlock> energy;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
#pragma GCC ivdep
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = begin + k;
    const Vector3 v = share * before.linear.at(i) + (time / by.mass[i]) * by.force.at(i);
    const Vector3 w = share * before.angular.at(i) + (time / by.rotary[i]) * by.moment.at(i);
    energy[k] = 0.5 * (by.mass[i] * dot(v, v) + by.rotary[i] * dot(w, w));
  }
  return base::sum_in_lanes(energy.data(), n);
}

/// The same of the relative masses of n elements.
KNITMECH_VECTORISE double relative_energy_pass(const Causes by, const Velocities before, const double* relative_mass,
                                               double share, double time, std::size_t begin, std::size_t n) {
  std::array<double, base::kBlock> energy;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
#pragma GCC ivdep
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = begin + k;
    const Vector3 start = share * before.linear.at(i) + (time / by.mass[i]) * by.force.at(i);
    const Vector3 end = share * before.linear.at(i + 1) + (time / by.mass[i + 1]) * by.force.at(i + 1);
    const Vector3 relative = end - start;
    energy[k] = 0.5 * relative_mass[i] * dot(relative, relative);
  }
  return base::sum_in_lanes(energy.data(), n);
}

double energy_at(const beam::NodalInertia& inertia, const model::NodalLoads& loads, const model::State& state,
                 double share, double time, const base::ThreadTeam& team) {
  const Causes by(inertia, loads);
  const Velocities before(state);
  const std::size_t n = inertia.mass.size();
  const double of_nodes = base::sum_over_blocks(team, n, [&](std::size_t begin, std::size_t end) {
    return energy_pass(by, before, share, time, begin, end - begin);
  });
  if (inertia.relative_mass.empty()) return of_nodes;
  const double* relative_mass = inertia.relative_mass.data();
  return of_nodes + base::sum_over_blocks(team, n - 1, [&](std::size_t begin, std::size_t end) {
           return relative_energy_pass(by, before, relative_mass, share, time, begin, end - begin);
         });
}

KNITMECH_VECTORISE double speed_pass(const Vectors velocity, std::size_t begin, std::size_t end) {
  double largest = 0;
  double spoilt = 0;  // 0, or not a number as soon as a speed is infinite or none
#pragma omp simd reduction(max : largest) reduction(+ : spoilt)
  for (std::size_t i = begin; i < end; ++i) {
    const double speed = dot(velocity.at(i), velocity.at(i));
    largest = largest > speed ? largest : speed;
    spoilt += 0 * speed;
  }
  return largest + spoilt;
}

}  // namespace

void integrate(const beam::NodalInertia& inertia, const model::NodalLoads& loads, StepLengths step, double mass_damping,
               model::State& state, const base::ThreadTeam& team) {
  const Causes by(inertia, loads);
  const Moving nodes(state);
  const Damped damped(step, mass_damping);
  team.for_ranges(inertia.mass.size(), base::kBlock,
                  [&](std::size_t begin, std::size_t end) { advance(by, nodes, damped, step.after, begin, end); });
  state.time += step.after;
}

double mass_damping_loss(const beam::NodalInertia& inertia, const model::NodalLoads& loads, StepLengths step,
                         double mass_damping, const model::State& state, const base::ThreadTeam& team) {
  if (mass_damping == 0) return 0;
  const Damped damped(step, mass_damping);
  const double energy = energy_at(inertia, loads, state, 0.5 * (1 + damped.kept), 0.5 * damped.gained, team);
  return 2 * mass_damping * step.mean() * energy;
}

double kinetic_energy(const beam::NodalInertia& inertia, const model::NodalLoads& loads, StepLengths step,
                      const model::State& state, const base::ThreadTeam& team) {
  return energy_at(inertia, loads, state, 1, 0.5 * step.before, team);
}

double largest_speed_squared(const model::State& state, const base::ThreadTeam& team) {
  const Vectors velocity(state.velocity);
  const std::vector<double> of_blocks =
      base::values_of_blocks(team, state.velocity.size(),
                             [&](std::size_t begin, std::size_t end) { return speed_pass(velocity, begin, end); });
  double largest = 0;
  for (const double of_block : of_blocks) {
    if (std::isnan(of_block)) return of_block;
    largest = std::max(largest, of_block);
  }
  return largest;
}

}  // namespace knitmech::solve
