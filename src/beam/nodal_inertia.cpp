#include "beam/nodal_inertia.h"

#include <algorithm>

namespace knitmech::beam {

namespace {

/// Rotary inertia in units of the least that keeps rotation from limiting the step [-]. More than one leaves room for
/// the stiffness that curvature and tension add to the rotations of a deformed yarn.
constexpr double kRotaryReserve = 2;

/// Least rotary inertia in units of the nodal share of mass times the length squared [-]. Contact on the smooth
/// centreline turns the nodes; with less inertia that would rule the time step. An element's mass spread along it has 1
/// / 12.
constexpr double kLeastRotary = 1.0 / 16;

}  // namespace

NodalInertia lump_inertia(const Elements& elements, double mass_scaling) {
  const std::size_t n = elements.size();
  NodalInertia inertia;
  inertia.mass.assign(n, 0.0);
  inertia.rotary.assign(n, 0.0);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (elements.mass[i] == 0) continue;
    const double length = 1 / elements.inverse_length[i];
    const double axial = elements.axial[i];
    const double shear = elements.shear[i];
    const double mass = 0.5 * mass_scaling * elements.mass[i];
    const double limit = std::max(2 * elements.stiffest[i], 4 * shear);  // [N], highest frequency squared times L0 m

    const double for_shear = mass * length * length * shear / (2 * (limit - 2 * shear));
    const double for_bending = 2 * mass * elements.bending[i] / limit;
    const double for_torsion = 2 * mass * elements.torsion[i] / limit;
    const double for_fold = 2 * mass * elements.fold[i] * length / limit;
    const double own = mass * elements.bending[i] / axial;
    const double rotary = std::max({kRotaryReserve * std::max({for_shear, for_bending, for_torsion, for_fold}),
                                    kLeastRotary * mass * length * length, own});

    for (const std::size_t node : {i, i + 1}) {
      inertia.mass[node] += mass;
      inertia.rotary[node] += rotary;
    }
    inertia.highest_frequency_squared = std::max(inertia.highest_frequency_squared, limit / (length * mass));
  }
  return inertia;
}

}  // namespace knitmech::beam
