#include "solve/integrate.h"

#include <cmath>
#include <limits>

#include "base/vectorise.h"

namespace knitmech::solve {

namespace {

/// One component of v or w over one step.
KNITMECH_VECTORISE void accelerate(const double* load, const double* inertia, double kept, double gained,
                                   double* __restrict velocity, std::size_t n) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) velocity[i] = kept * velocity[i] + gained * load[i] / inertia[i];
}

KNITMECH_VECTORISE void move(const double* velocity, double step, double* __restrict position, std::size_t n) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) position[i] += step * velocity[i];
}

/// q <- exp(step w) q. The half angle of one step is small: sine and cosine by their series, exact to rounding below
/// 0.1, then one Newton step of the normalisation, which also keeps rounding from adding up.
KNITMECH_VECTORISE void turn(const double* wx, const double* wy, const double* wz, double step, double* __restrict qw,
                             double* __restrict qx, double* __restrict qy, double* __restrict qz, std::size_t n) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    const double hx = 0.5 * step * wx[i];
    const double hy = 0.5 * step * wy[i];
    const double hz = 0.5 * step * wz[i];
    const double h2 = hx * hx + hy * hy + hz * hz;
    const double cosine = 1 - h2 * (1.0 / 2) * (1 - h2 * (1.0 / 12) * (1 - h2 * (1.0 / 30)));
    const double sine = 1 - h2 * (1.0 / 6) * (1 - h2 * (1.0 / 20) * (1 - h2 * (1.0 / 42)));
    const double sx = sine * hx;
    const double sy = sine * hy;
    const double sz = sine * hz;
    const double w = cosine * qw[i] - sx * qx[i] - sy * qy[i] - sz * qz[i];
    const double x = cosine * qx[i] + sx * qw[i] + sy * qz[i] - sz * qy[i];
    const double y = cosine * qy[i] + sy * qw[i] + sz * qx[i] - sx * qz[i];
    const double z = cosine * qz[i] + sz * qw[i] + sx * qy[i] - sy * qx[i];
    const double unit = 1.5 - 0.5 * (w * w + x * x + y * y + z * z);
    qw[i] = unit * w;
    qx[i] = unit * x;
    qy[i] = unit * y;
    qz[i] = unit * z;
  }
}

double squared(Vector3 v) {
  return dot(v, v);
}

}  // namespace

void integrate(const beam::NodalInertia& inertia, const model::NodalLoads& loads, StepLengths step, double mass_damping,
               model::State& state) {
  const std::size_t n = inertia.mass.size();
  const double damping = 0.5 * mass_damping * step.mean();
  const double kept = (1 - damping) / (1 + damping);
  const double gained = step.mean() / (1 + damping);

  model::VectorArray& v = state.velocity;
  accelerate(loads.force.x.data(), inertia.mass.data(), kept, gained, v.x.data(), n);
  accelerate(loads.force.y.data(), inertia.mass.data(), kept, gained, v.y.data(), n);
  accelerate(loads.force.z.data(), inertia.mass.data(), kept, gained, v.z.data(), n);
  model::VectorArray& w = state.angular_velocity;
  accelerate(loads.moment.x.data(), inertia.rotary.data(), kept, gained, w.x.data(), n);
  accelerate(loads.moment.y.data(), inertia.rotary.data(), kept, gained, w.y.data(), n);
  accelerate(loads.moment.z.data(), inertia.rotary.data(), kept, gained, w.z.data(), n);

  move(v.x.data(), step.after, state.position.x.data(), n);
  move(v.y.data(), step.after, state.position.y.data(), n);
  move(v.z.data(), step.after, state.position.z.data(), n);
  model::RotationArray& q = state.rotation;
  turn(w.x.data(), w.y.data(), w.z.data(), step.after, q.w.data(), q.x.data(), q.y.data(), q.z.data(), n);
  state.time += step.after;
}

double kinetic_energy(const beam::NodalInertia& inertia, const model::NodalLoads& loads, StepLengths step,
                      const model::State& state) {
  const double half = 0.5 * step.before;
  double energy = 0;
  for (std::size_t i = 0; i < inertia.mass.size(); ++i) {
    const Vector3 v = state.velocity.at(i) + (half / inertia.mass[i]) * loads.force.at(i);
    const Vector3 w = state.angular_velocity.at(i) + (half / inertia.rotary[i]) * loads.moment.at(i);
    energy += 0.5 * (inertia.mass[i] * squared(v) + inertia.rotary[i] * squared(w));
  }
  return energy;
}

double largest_speed_squared(const model::State& state) {
  double largest = 0;
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    const double speed = squared(state.velocity.at(i));
    if (!(speed <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::quiet_NaN();
    largest = std::max(largest, speed);
  }
  return largest;
}

}  // namespace knitmech::solve
