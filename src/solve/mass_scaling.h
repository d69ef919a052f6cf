#pragma once

#include "model/case.h"
#include "model/model.h"

namespace knitmech::solve {

/// The mass scaling of `mass_scaling = "auto"`: as much as a quasi-static wale test bears.
///
/// Inertia and bending stiffness of a yarn give one speed, sqrt(EI / (rho A)) / l with l the length of a half stitch:
/// that at which a bent loop can follow the pull. With all masses multiplied by s it falls by sqrt(s), so that only v
/// sqrt(s) counts, v the speed of the grip. The scaling keeps
///
///     v sqrt(s) = kQuasiStaticSpeed sqrt(EI / (rho A)) / l,
///
/// and is never less than 1. kQuasiStaticSpeed was measured on the published fabric (constants.h). The number of
/// stitches does not enter: with more of them the test lasts longer in proportion. Whether the result is quasi-static
/// is judged after the run, from its energies and forces, whatever the scaling was.
[[nodiscard]] double automatic_mass_scaling(const model::Model& model);

/// Finest length of the selective mass of a model [mm], see beam::lump_inertia(): kSelectiveShare of a half stitch; 0,
/// none, where yarns are tied or can break: the forces of ties and what a break leaves behind stand on lumped masses.
[[nodiscard]] double selective_length(const model::Model& model);

/// Whether the speed of the grip is adapted while a case runs (see Pace): if the program chooses the mass, and unless
/// the test is so fast that masses are not scaled, which is then meant.
[[nodiscard]] bool adapts_pace(const model::Case& input, double mass_scaling);

}  // namespace knitmech::solve
