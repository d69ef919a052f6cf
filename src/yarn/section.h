#pragma once

#include <optional>

namespace knitmech::yarn {

/// Stiffness and mass of a yarn with a circular (isotropic) section, per unit of its length.
struct Section {
  double diameter = 0;             ///< D [mm], outer diameter, seen by the contact
  double axial_stiffness = 0;      ///< EA [N]
  double shear_stiffness = 0;      ///< k G A [N], k the shear factor, before any slenderness compensation
  double bending_stiffness = 0;    ///< EI [N mm^2], the same about both axes
  double torsional_stiffness = 0;  ///< GJ [N mm^2]
  double mass_per_length = 0;      ///< rho A [t/mm], not scaled

  /// EA / EI, which is A / I [1/mm^2] for a beam of one material, but at most 16 / D^2, that of a solid circle. A yarn
  /// of loose filaments bends far more easily than its outline says; the shear stiffness of its elements
  /// (beam::compensated_shear_stiffness) must not fall with it, or its sections would turn against the yarn freely.
  [[nodiscard]] double slenderness() const {
    const double of_circle = 16 / (diameter * diameter);
    const double of_stiffness = axial_stiffness / bending_stiffness;
    return of_stiffness < of_circle ? of_stiffness : of_circle;
  }
};

/// What a material test gives for a monofilament.
struct Monofilament {
  double diameter = 0;        ///< D [mm]
  double youngs_modulus = 0;  ///< E [MPa]
  double poissons_ratio = 0;  ///< nu [-]
  double density = 0;         ///< rho [t/mm^3]
  /// G [MPa], if it was measured. It takes the place of nu, which is then not looked at: drawn filaments are stiffer
  /// along their chains than isotropic theory, G = E / (2 (1 + nu)), would have it.
  std::optional<double> shear_modulus{};
};

/// A yarn of equal filaments twisted together.
struct Multifilament {
  int filaments = 0;      ///< n, how many
  Monofilament filament;  ///< one of them: its own diameter d_f, moduli and density
  double diameter = 0;    ///< D [mm], of the whole yarn
  double twist = 0;       ///< t [1/mm], turns per length of the yarn; its sense does not matter
};

}  // namespace knitmech::yarn
