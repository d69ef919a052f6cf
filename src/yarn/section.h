#pragma once

namespace knitmech::yarn {

/// Stiffness and mass of a yarn with a circular (isotropic) section, per unit of its length.
struct Section {
  double diameter = 0;             ///< D [mm], outer diameter, seen by the contact
  double axial_stiffness = 0;      ///< EA [N]
  double shear_stiffness = 0;      ///< k G A [N], k the shear factor, before any slenderness compensation
  double bending_stiffness = 0;    ///< EI [N mm^2], the same about both axes
  double torsional_stiffness = 0;  ///< GJ [N mm^2]
  double mass_per_length = 0;      ///< rho A [t/mm], not scaled
};

/// What a material test gives for a monofilament.
struct Monofilament {
  double diameter = 0;        ///< D [mm]
  double youngs_modulus = 0;  ///< E [MPa]
  double poissons_ratio = 0;  ///< nu [-]
  double density = 0;         ///< rho [t/mm^3]
};

}  // namespace knitmech::yarn
