#pragma once

#include <functional>
#include <vector>

#include "beam/nodal_inertia.h"
#include "solve/selective_mass.h"

namespace knitmech::solve {

/// The row sums of a stiffness scaled with given inertias of displacements and rotations: for each of them i
///
///     sum over j of |K(i, j)| / sqrt(M_i M_j),
///
/// first of all displacements, then of all rotations [1/s^2]; see contact::FrequencyBound.
using ScaledRows =
    std::function<std::vector<double>(const std::vector<double>& mass, const std::vector<double>& rotary)>;

/// Upper bound of the square of the highest frequency that a stiffness K gives the nodes [1/s^2].
///
/// With nodes that move for themselves it is the largest row sum. With selective masses M it is
///
///     max over i of (inverse(M) |K| d)_i / d_i
///
/// for the better of two sets of positive numbers d (any such set gives a bound, as no entry of inverse(M) is negative:
/// Collatz and Wielandt): first 1 / sqrt of the mass that a force on the node alone moves; then what inverse(M) |K| d
/// has become with these, which is near the motion at that frequency and so near the best bound. Grips only take motion
/// away from the nodes, which does not raise a frequency.
[[nodiscard]] double highest_frequency_squared(const ScaledRows& rows, const beam::NodalInertia& inertia,
                                               const SelectiveMass& masses);

}  // namespace knitmech::solve
