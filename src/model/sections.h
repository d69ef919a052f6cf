#pragma once

#include <optional>

#include "model/case.h"
#include "yarn/axial_law.h"
#include "yarn/section.h"

namespace knitmech::model {

/// The section of the yarn of a case: of a monofilament, of a twisted multifilament, or as given outright; see
/// YarnStiffness. With a measured tensile curve, its slope at zero strain stands for EA, and with a monofilament for
/// E = EA / A. Throws InputError unless the stiffness is given in just one of these ways.
[[nodiscard]] yarn::Section section_of(const Case& input);

/// The measured tensile curve of the yarn of a case, if it has one. Throws InputError that names the point for a curve
/// that cannot be.
[[nodiscard]] std::optional<yarn::AxialLaw> axial_law_of(const Case& input);

/// The section of the turning arcs. What `edge_yarn` does not say is that of the yarn, but for the bending stiffness,
/// kEdgeBendingStiffness, and the torsional stiffness, GJ / EI as in the yarn.
[[nodiscard]] yarn::Section edge_section_of(const Case& input);

}  // namespace knitmech::model
