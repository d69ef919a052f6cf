#pragma once

#include "beam/nodal_inertia.h"
#include "contact/springs.h"
#include "solve/selective_mass.h"

namespace knitmech::solve {

/// Upper bound of the square of the highest frequency that springs of the stiffness K give nodes of the masses M
/// [1/s^2],
///
///     max over i of (inverse(M) |K| d)_i / d_i
///
/// over all displacements and rotations i, for the better of two sets of positive numbers d. Any such set gives a
/// bound, as no entry of inverse(M) is negative (Collatz and Wielandt): first 1 / sqrt of the mass that a force on the
/// node alone moves, and of its rotary inertia, which is Gershgorin's bound where the masses are lumped; then what
/// inverse(M) |K| d has become with these, which is near the motion at that frequency and so near the best bound. Grips
/// only take motion away from the nodes, which does not raise a frequency.
[[nodiscard]] double highest_frequency_squared(const contact::Springs& springs, const beam::NodalInertia& inertia,
                                               const SelectiveMass& masses);

}  // namespace knitmech::solve
