#pragma once

#include "model/model.h"

namespace knitmech::exchange {

/// A square section with the EA, EI and GJ of a yarn, for beams of CalculiX:
///   a^2 = 12 EI / EA,  E = EA / a^2,  G = GJ / J,  J = a^4 / 6.
///
/// CalculiX expands a beam into one 20-node brick, which has no room for the warping of a square: its torsion constant
/// is the polar moment 2 I. E and G are free of each other, as the material is orthotropic without contraction across.
struct CalculixSquare {
  double side = 0;            ///< a [mm]
  double youngs_modulus = 0;  ///< E [MPa], along all three axes
  double shear_modulus = 0;   ///< G [MPa], in all three planes
};

/// The square with the stiffness of a yarn section. All members of the section must be positive.
[[nodiscard]] CalculixSquare calculix_square(const yarn::Section& section);

/// The material of a solid round yarn.
struct CalculixMaterial {
  double youngs_modulus = 0;  ///< E [MPa]
  double poissons_ratio = 0;  ///< nu [-]
};

/// @throws InputError where EA, EI and GJ are not those of a solid circle of the yarn's diameter
[[nodiscard]] CalculixMaterial calculix_material(const yarn::Section& section);

}  // namespace knitmech::exchange
