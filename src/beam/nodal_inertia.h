#pragma once

#include <cstddef>
#include <vector>

#include "beam/elements.h"

namespace knitmech::beam {

/// Lumped masses of the nodes and the frequency that they allow.
struct NodalInertia {
  std::vector<double> mass;              ///< [t], one entry per node
  std::vector<double> rotary;            ///< [t mm^2], the same about every axis
  double highest_frequency_squared = 0;  ///< [1/s^2], upper bound for the beams alone, without contact
  /// b [t] of the element that starts at each node, which resists the relative motion of its two nodes: their kinetic
  /// energy has b |v_b - v_a|^2 / 2 besides. Empty: none.
  std::vector<double> relative_mass = {};

  /// Relative mass of the element that starts at a node [t].
  [[nodiscard]] double relative_mass_at(std::size_t node) const {
    return relative_mass.empty() ? 0 : relative_mass[node];
  }
};

/// Half of each element's mass to each of its nodes, and as much rotary inertia as keeps rotation from limiting the
/// step.
///
/// With the nodal share m = rho A L0 / 2 and rotary share J of an element, its highest frequencies are
///
///     axial    w^2 = 2 EA / (L0 m)
///     shear    w^2 = k G A' (2 / (L0 m) + L0 / (2 J))
///     bending  w^2 = 2 EI / (L0 J)
///     torsion  w^2 = 2 GJ / (L0 J)
///     folding  w^2 = 2 k / J
///
/// (eigenvalues of the element's stiffness, which couples lateral motion with the sum of the rotations and nothing
/// else), EA the largest slope of a measured curve in the first. J is twice the least value for which none of the last
/// four exceeds max(2 EA, 4 k G A') / (L0 m), and never less than the section's own rotary inertia rho I L0 / 2. The
/// highest frequency of the assembled mesh is at most the highest of any element (Irons and Treharne 1971).
///
/// A finest length d [mm] asks for selective mass: as much relative mass b as brings the axial frequency of every
/// element down to that of the stiffest yarn in elements of the length d, w^2 = 2 EA / (d rho A d / 2). With b, an
/// element moves m + 2 b where its ends move against each other, and that stands for m in the frequencies above. \param
/// mass_scaling factor on all masses \param finest_length d [mm]; 0: no relative mass
[[nodiscard]] NodalInertia lump_inertia(const Elements& elements, double mass_scaling, double finest_length = 0);

}  // namespace knitmech::beam
