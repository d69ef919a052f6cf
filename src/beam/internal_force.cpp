#include "beam/internal_force.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/blocks.h"
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

/// What one block of elements passes on to its nodes. Entry k + 1 is the k-th element's; entry 0 is that of the last
/// element of the block before, if this thread had it, and the entry behind the last stays zero.
struct BlockLoads {
  struct Axis {
    using Values = std::array<double, base::kBlock + 2>;
    Values force;  // on the first node; the second gets the opposite
    Values on_first, on_second;
  };
  Axis x, y, z;
  std::array<double, base::kBlock> loss;

  /// Sets entry 0 to that of an element (0: to zero), and the entry behind n elements to zero.
  void set_ends(std::size_t element_before, std::size_t n) {
    for (Axis* axis : {&x, &y, &z}) {
      for (Axis::Values* values : {&axis->force, &axis->on_first, &axis->on_second}) {
        (*values)[0] = element_before > 0 ? (*values)[element_before] : 0;
        (*values)[n + 1] = 0;
      }
    }
  }
};

/// \param before approach of the elements, see ElementWork
KNITMECH_VECTORISE void element_pass(const Input in, std::size_t begin, std::size_t n, double step,
                                     double* __restrict before, BlockLoads& out) {
#pragma GCC ivdep
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = begin + k;
    const ElementProperties element = in.properties(i);
    const ElementState state = in.state(element, i);
    const double approach = state.inverse_chord * dot(in.chord(i), in.speed_difference(i));
    const double viscous = in.viscosity[i] * approach;
    const ElementLoads loads = element_loads(state, state.force + (viscous * state.inverse_chord) * state.chord);
    out.x.force[k + 1] = loads.force_a.x;
    out.y.force[k + 1] = loads.force_a.y;
    out.z.force[k + 1] = loads.force_a.z;
    out.x.on_first[k + 1] = loads.moment_a.x;
    out.y.on_first[k + 1] = loads.moment_a.y;
    out.z.on_first[k + 1] = loads.moment_a.z;
    out.x.on_second[k + 1] = loads.moment_b.x;
    out.y.on_second[k + 1] = loads.moment_b.y;
    out.z.on_second[k + 1] = loads.moment_b.z;
    out.loss[k] = 0.5 * step * in.viscosity[i] * before[i] * (before[i] + approach);
    before[i] = approach;
  }
}

/// Node k of the block gets the loads of the element that starts there and of the one that ends there.
KNITMECH_VECTORISE void gather_pass(const BlockLoads::Axis& axis, double* __restrict force, double* __restrict moment,
                                    std::size_t n_nodes) {
#pragma GCC ivdep
  for (std::size_t k = 0; k < n_nodes; ++k) {
    force[k] = axis.force[k + 1] - axis.force[k];
    moment[k] = axis.on_first[k + 1] + axis.on_second[k];
  }
}

KNITMECH_VECTORISE double sum_of_losses(const BlockLoads& loads, std::size_t n) {
  return base::sum_in_lanes(loads.loss.data(), n);
}

KNITMECH_VECTORISE double energy_pass(const Input in, std::size_t begin, std::size_t n) {
  std::array<double, base::kBlock> energy;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
#pragma GCC ivdep
  for (std::size_t k = 0; k < n; ++k) {
    const ElementProperties element = in.properties(begin + k);
    energy[k] = strain_energy(element, in.state(element, begin + k));
  }
  return base::sum_in_lanes(energy.data(), n);
}

KNITMECH_VECTORISE double stretch_energy_pass(const Input in, std::size_t begin, std::size_t n) {
  std::array<double, base::kBlock> energy;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
#pragma GCC ivdep
  for (std::size_t k = 0; k < n; ++k) {
    const ElementProperties element = in.properties(begin + k);
    energy[k] = stretch_energy(element, in.state(element, begin + k));
  }
  return base::sum_in_lanes(energy.data(), n);
}

/// Elements that start at the nodes from begin to end; at the very last node there starts none.
std::size_t elements_of(std::size_t begin, std::size_t end, std::size_t n_nodes) {
  return std::min(end, n_nodes - 1) - begin;
}

/// \param n elements in the block
void keep_for_next_block(const BlockLoads& from, std::size_t n, std::size_t block, model::NodalLoads& to) {
  to.force.set(block, {-from.x.force[n], -from.y.force[n], -from.z.force[n]});
  to.moment.set(block, {from.x.on_second[n], from.y.on_second[n], from.z.on_second[n]});
}

}  // namespace

ElementWork::ElementWork(std::size_t n_nodes)
    : approach(n_nodes, 0.0), damping_loss(base::n_blocks(n_nodes), 0.0), on_next_block(base::n_blocks(n_nodes)) {}

void set_internal_force(const Elements& elements, const model::State& state, double step, ElementWork& work,
                        model::NodalLoads& loads, const base::ThreadTeam& team) {
  const Input in(elements, state);
  const std::size_t n_nodes = elements.size();
  team.for_ranges(n_nodes, base::kBlock, [&](std::size_t first, std::size_t last) {
    BlockLoads of_block;  // NOLINT(cppcoreguidelines-pro-type-member-init): all that is read is written first
    std::size_t n = 0;
    for (std::size_t begin = first; begin < last; begin += base::kBlock) {
      const std::size_t end = std::min(begin + base::kBlock, last);
      const std::size_t n_before = n;
      n = elements_of(begin, end, n_nodes);
      of_block.set_ends(n_before, n);
      element_pass(in, begin, n, step, work.approach.data(), of_block);
      gather_pass(of_block.x, &loads.force.x[begin], &loads.moment.x[begin], end - begin);
      gather_pass(of_block.y, &loads.force.y[begin], &loads.moment.y[begin], end - begin);
      gather_pass(of_block.z, &loads.force.z[begin], &loads.moment.z[begin], end - begin);
      work.damping_loss[begin / base::kBlock] += sum_of_losses(of_block, n);
    }
    keep_for_next_block(of_block, n, (last - 1) / base::kBlock, work.on_next_block);
  });
  for (std::size_t part = 1; part < team.size(); ++part) {
    const auto [begin, end] = team.range_of(part, n_nodes, base::kBlock);
    if (begin == 0 || begin == end) continue;
    loads.force.add(begin, work.on_next_block.force.at(begin / base::kBlock - 1));
    loads.moment.add(begin, work.on_next_block.moment.at(begin / base::kBlock - 1));
  }
}

double strain_energy(const Elements& elements, const model::State& state, const base::ThreadTeam& team) {
  const Input in(elements, state);
  return base::sum_over_blocks(team, elements.size(), [&](std::size_t begin, std::size_t end) {
    return energy_pass(in, begin, elements_of(begin, end, elements.size()));
  });
}

double stretch_energy(const Elements& elements, const model::State& state, const base::ThreadTeam& team) {
  const Input in(elements, state);
  return base::sum_over_blocks(team, elements.size(), [&](std::size_t begin, std::size_t end) {
    return stretch_energy_pass(in, begin, elements_of(begin, end, elements.size()));
  });
}

double damping_loss(const ElementWork& work) {
  return std::accumulate(work.damping_loss.begin(), work.damping_loss.end(), 0.0);
}

}  // namespace knitmech::beam
