#include "beam/nodal_inertia.h"

#include <algorithm>
#include <cmath>

namespace knitmech::beam {

namespace {

/// Rotary inertia in units of the least that keeps rotation from limiting the step [-]. More than one leaves room for
/// the stiffness that curvature and tension add to the rotations of a deformed yarn.
constexpr double kRotaryReserve = 2;

/// Least rotary inertia in units of the nodal share of mass times the length squared [-]. Contact on the smooth
/// centreline turns the nodes; with less inertia that would rule the time step. An element's mass spread along it has 1
/// / 12. A force amid a yarn with relative mass moves the root of m (m + 2 b) in place of m, so the least goes with it.
constexpr double kLeastRotary = 1.0 / 16;

/// Highest frequency squared of an element, times the mass that each end moves and the length [N].
double stiffness_limit(const Elements& elements, std::size_t i) {
  return std::max(2 * elements.stiffest[i], 4 * elements.shear[i]);
}

/// The frequency squared [1/s^2] of the stiffest yarn in elements of a length [mm] that are longer than those there
/// are.
double frequency_squared_at(const Elements& elements, double mass_scaling, double finest_length) {
  double highest = 0;
  for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
    if (elements.mass[i] == 0) continue;
    const double length = std::max(finest_length, 1 / elements.inverse_length[i]);
    const double mass = 0.5 * mass_scaling * elements.mass[i] * elements.inverse_length[i] * length;
    highest = std::max(highest, stiffness_limit(elements, i) / (length * mass));
  }
  return highest;
}

}  // namespace

NodalInertia lump_inertia(const Elements& elements, double mass_scaling, double finest_length) {
  const std::size_t n = elements.size();
  NodalInertia inertia;
  inertia.mass.assign(n, 0.0);
  inertia.rotary.assign(n, 0.0);
  if (finest_length > 0) inertia.relative_mass.assign(n, 0.0);
  const double wanted = finest_length > 0 ? frequency_squared_at(elements, mass_scaling, finest_length) : 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (elements.mass[i] == 0) continue;
    const double length = 1 / elements.inverse_length[i];
    const double axial = elements.axial[i];
    const double shear = elements.shear[i];
    const double mass = 0.5 * mass_scaling * elements.mass[i];
    const double limit = stiffness_limit(elements, i);
    const double moved = wanted > 0 ? std::max(mass, limit / (length * wanted)) : mass;
    if (wanted > 0) inertia.relative_mass[i] = 0.5 * (moved - mass);

    const double for_shear = moved * length * length * shear / (2 * (limit - 2 * shear));
    const double for_bending = 2 * moved * elements.bending[i] / limit;
    const double for_torsion = 2 * moved * elements.torsion[i] / limit;
    const double for_fold = 2 * moved * elements.fold[i] * length / limit;
    const double own = mass * elements.bending[i] / axial;
    const double rotary = std::max({kRotaryReserve * std::max({for_shear, for_bending, for_torsion, for_fold}),
                                    kLeastRotary * std::sqrt(mass * moved) * length * length, own});

    for (const std::size_t node : {i, i + 1}) {
      inertia.mass[node] += mass;
      inertia.rotary[node] += rotary;
    }
    inertia.highest_frequency_squared = std::max(inertia.highest_frequency_squared, limit / (length * moved));
  }
  return inertia;
}

}  // namespace knitmech::beam
