#pragma once

#include "beam/elements.h"
#include "model/frame.h"
#include "model/state.h"

namespace knitmech::beam {

/// Fills the element fields of a frame: axial and shear force, bending moment, torque, axial strain, curvature, and the
/// strain energy by stretch (with shear), bending and twist, which add up to the strain energy (see Frame). Elements
/// with a measured law: NonlinearAxial corrects their stretch energy.
void set_section_results(const Elements& elements, const model::State& state, model::Frame& frame);

}  // namespace knitmech::beam
