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
  double stiffness = 0;  ///< K of a crossing [N/mm]
  FrictionTable friction;
};

/// What a step of all contacts comes to.
struct ContactStep {
  double friction_loss = 0;        ///< [mJ]
  double largest_penetration = 0;  ///< [mm]
};

/// Brings the followed places up to date with the centreline and adds their normal and friction forces to the nodes.
/// \param step [s] since the call before; velocities times step are the motion since then
/// \param lost set if a yarn went through another in this step
ContactStep add_smooth_forces(const YarnElements& elements, const Centreline& line, const SmoothLaw& law,
                              const Motion& motion, const model::State& state, double step, FollowedContacts& contacts,
                              model::NodalLoads& loads, std::optional<LostCrossing>& lost);

}  // namespace knitmech::contact
