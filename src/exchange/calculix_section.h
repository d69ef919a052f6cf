#pragma once

#include "model/model.h"

namespace knitmech::exchange {

/// The material of a solid round yarn.
struct CalculixMaterial {
  double youngs_modulus = 0;  ///< E [MPa]
  double poissons_ratio = 0;  ///< nu [-]
};

/// @throws InputError where EA, EI and GJ are not those of a solid circle of the yarn's diameter
[[nodiscard]] CalculixMaterial calculix_material(const yarn::Section& section);

}  // namespace knitmech::exchange
