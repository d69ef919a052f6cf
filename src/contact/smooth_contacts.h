#pragma once

#include <optional>
#include <vector>

#include "contact/centreline.h"
#include "contact/contact_points.h"
#include "contact/followed_contacts.h"
#include "contact/friction_table.h"
#include "model/state.h"

namespace knitmech::contact {

/// What contact on the smooth centreline needs to know besides the yarns.
struct SmoothLaw {
  double stiffness;  ///< K of a crossing [N/mm]
  FrictionTable friction;
};

/// Brings the followed places up to date with the centreline, adds their normal and friction forces to the nodes, and
/// lists those that carry a force. Replaces `found`.
/// \param step [s] since the call before; velocities times step are the motion since then
/// \param lost set if a yarn went through another in this step
/// \return friction loss of this step [mJ]
double add_smooth_forces(const YarnElements& elements, const Centreline& line, const SmoothLaw& law,
                         const Motion& motion, const model::State& state, double step, FollowedContacts& contacts,
                         model::NodalLoads& loads, std::vector<ContactPoint>& found, std::optional<LostCrossing>& lost);

}  // namespace knitmech::contact
