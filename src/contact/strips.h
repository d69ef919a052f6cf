#pragma once

#include "contact/followed_contacts.h"
#include "contact/smooth_contacts.h"

namespace knitmech::contact {

/// Long overlaps, where yarns lie side by side or wind about each other: one yarn is cut into short strips, the other
/// into cells, and every strip sees the cells that are near it,
///
///     energy = k  sum over strips  w  sum over cells  integral of e(D - |x_b(t) - x_a|) dT
///
/// (the energy of line_potential.h, w the length of a strip). Strips, cells and all points on them stay where they are
/// on the yarns, and the integral along a cell is exact in the depths at its three points (cell_law.h). So the energy
/// is a function of the positions of these points alone: there is no closest place to be found, none that could jump or
/// vanish where a yarn winds round another so tightly that all its places are equally near, and the forces are exact
/// derivatives.
/// \return friction loss and largest penetration
ContactStep add_strip_forces(const YarnElements& elements, const Centreline& line, const SmoothLaw& law,
                             const Motion& motion, const model::State& state, double step, FollowedContacts& contacts,
                             model::NodalLoads& loads, std::optional<LostCrossing>& lost);

}  // namespace knitmech::contact
