#include "beam/internal_force.h"

#include <numeric>

#include "beam/element.h"

namespace knitmech::beam {

namespace {

/// Read-only view of the arrays that the loops run over.
struct Input {
  const double *x, *y, *z, *qw, *qx, *qy, *qz, *vx, *vy, *vz;
  const double *axis_x, *axis_y, *axis_z, *inverse_length, *axial, *shear, *torsion, *bending, *viscosity;

  Input(const Elements& e, const model::State& s)
      : x(s.position.x.data()),
        y(s.position.y.data()),
        z(s.position.z.data()),
        qw(s.rotation.w.data()),
        qx(s.rotation.x.data()),
        qy(s.rotation.y.data()),
        qz(s.rotation.z.data()),
        vx(s.velocity.x.data()),
        vy(s.velocity.y.data()),
        vz(s.velocity.z.data()),
        axis_x(e.axis_x.data()),
        axis_y(e.axis_y.data()),
        axis_z(e.axis_z.data()),
        inverse_length(e.inverse_length.data()),
        axial(e.axial.data()),
        shear(e.shear.data()),
        torsion(e.torsion.data()),
        bending(e.bending.data()),
        viscosity(e.viscosity.data()) {}

  [[nodiscard]] KNITMECH_INLINE ElementProperties properties(std::size_t i) const {
    return {{axis_x[i], axis_y[i], axis_z[i]}, inverse_length[i], axial[i], shear[i], torsion[i], bending[i]};
  }
  [[nodiscard]] KNITMECH_INLINE ElementState state(const ElementProperties& element, std::size_t i) const {
    return element_state(element, chord(i), {qw[i], {qx[i], qy[i], qz[i]}},
                         {qw[i + 1], {qx[i + 1], qy[i + 1], qz[i + 1]}});
  }
  [[nodiscard]] KNITMECH_INLINE Vector3 chord(std::size_t i) const {
    return {x[i + 1] - x[i], y[i + 1] - y[i], z[i + 1] - z[i]};
  }
  [[nodiscard]] KNITMECH_INLINE Vector3 speed_difference(std::size_t i) const {
    return {vx[i + 1] - vx[i], vy[i + 1] - vy[i], vz[i + 1] - vz[i]};
  }
};

struct Output {
  double* __restrict fx, * __restrict fy, * __restrict fz;
  double* __restrict ax, * __restrict ay, * __restrict az;
  double* __restrict bx, * __restrict by, * __restrict bz;
  double* __restrict approach;
  double* __restrict loss;

  explicit Output(ElementWork& w)
      : fx(w.force_a.x.data()),
        fy(w.force_a.y.data()),
        fz(w.force_a.z.data()),
        ax(w.moment_a.x.data()),
        ay(w.moment_a.y.data()),
        az(w.moment_a.z.data()),
        bx(w.moment_b.x.data()),
        by(w.moment_b.y.data()),
        bz(w.moment_b.z.data()),
        approach(w.approach.data()),
        loss(w.damping_loss.data()) {}
};

KNITMECH_VECTORISE void element_pass(const Input in, const Output out, std::size_t n, double step) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    const ElementProperties element = in.properties(i);
    const ElementState state = in.state(element, i);
    const double approach = state.inverse_chord * dot(in.chord(i), in.speed_difference(i));
    const double viscous = in.viscosity[i] * approach;
    const ElementLoads loads = element_loads(state, state.force + (viscous * state.inverse_chord) * state.chord);
    out.fx[i] = loads.force_a.x;
    out.fy[i] = loads.force_a.y;
    out.fz[i] = loads.force_a.z;
    out.ax[i] = loads.moment_a.x;
    out.ay[i] = loads.moment_a.y;
    out.az[i] = loads.moment_a.z;
    out.bx[i] = loads.moment_b.x;
    out.by[i] = loads.moment_b.y;
    out.bz[i] = loads.moment_b.z;
    const double before = out.approach[i];
    out.loss[i] += 0.5 * step * in.viscosity[i] * before * (before + approach);
    out.approach[i] = approach;
  }
}

/// node i gets `at_a` of the element that starts there plus `sign` times `at_b` of the element that ends there.
KNITMECH_VECTORISE void gather_pass(const double* at_a, const double* at_b, double sign, double* __restrict node,
                                    std::size_t n_nodes) {
  node[0] = at_a[0];
#pragma GCC ivdep
  for (std::size_t i = 1; i + 1 < n_nodes; ++i) node[i] = at_a[i] + sign * at_b[i - 1];
  node[n_nodes - 1] = sign * at_b[n_nodes - 2];
}

}  // namespace

void set_internal_force(const Elements& elements, const model::State& state, double step, ElementWork& work,
                        model::NodalLoads& loads) {
  const std::size_t n = elements.size();
  element_pass(Input(elements, state), Output(work), n - 1, step);

  gather_pass(work.force_a.x.data(), work.force_a.x.data(), -1, loads.force.x.data(), n);
  gather_pass(work.force_a.y.data(), work.force_a.y.data(), -1, loads.force.y.data(), n);
  gather_pass(work.force_a.z.data(), work.force_a.z.data(), -1, loads.force.z.data(), n);
  gather_pass(work.moment_a.x.data(), work.moment_b.x.data(), 1, loads.moment.x.data(), n);
  gather_pass(work.moment_a.y.data(), work.moment_b.y.data(), 1, loads.moment.y.data(), n);
  gather_pass(work.moment_a.z.data(), work.moment_b.z.data(), 1, loads.moment.z.data(), n);
}

double strain_energy(const Elements& elements, const model::State& state) {
  const Input in(elements, state);
  double energy = 0;
  for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
    const ElementProperties element = in.properties(i);
    energy += strain_energy(element, in.state(element, i));
  }
  return energy;
}

double damping_loss(const ElementWork& work) {
  return std::accumulate(work.damping_loss.begin(), work.damping_loss.end(), 0.0);
}

}  // namespace knitmech::beam
