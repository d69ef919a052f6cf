#pragma once

#include "beam/elements.h"
#include "model/frame.h"
#include "model/state.h"

namespace knitmech::beam {

/// Fills the element fields of a frame: axial and shear force, bending moment, torque, curvature (see Frame).
void set_section_results(const Elements& elements, const model::State& state, model::Frame& frame);

}  // namespace knitmech::beam
