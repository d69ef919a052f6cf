#pragma once

#include <Eigen/Core>

#include "yarn/section.h"

namespace knitmech::exchange {

/// The numbers of a yarn section as Abaqus asks for them.
///
/// If a solid circle of one isotropic material has the stiffness of the yarn, that is EI = EA D^2 / 16 to rounding and
/// the GJ of a Poisson's ratio between -1 and 0.5, then
///   E = EA / A,  G = GJ / J,  nu = E / (2 G) - 1,  with A = pi D^2 / 4 and J = pi D^4 / 32.
/// E, nu and rho are rounded to 12 digits there, to show the 1700 MPa of the input, not the noise of the division.
/// Otherwise the section is general:
///   E = EA / A,  I = EI / E,  J = 2 I,  G = GJ / J,
/// which gives back EA, EI and GJ exactly as products; E, G, I and J have no meaning of their own then.
struct AbaqusSection {
  bool circle = false;          ///< *BEAM SECTION, SECTION=CIRC; otherwise *BEAM GENERAL SECTION, SECTION=GENERAL
  double radius = 0;            ///< D / 2 [mm]
  double area = 0;              ///< A [mm^2]
  double inertia = 0;           ///< I [mm^4], about both axes
  double torsion_constant = 0;  ///< J [mm^4]
  double youngs_modulus = 0;    ///< E [MPa]
  double poissons_ratio = 0;    ///< nu [-], of a circle
  double shear_modulus = 0;     ///< G [MPa]
  double density = 0;           ///< rho [t/mm^3]
  double shear_stiffness = 0;   ///< K23 = K13 = k G A [N], before slenderness compensation
  double slenderness_compensation = 0;  ///< factor [-], with which Abaqus gets the shear stiffness of beam/elements.h
};

/// The Abaqus section with the stiffness and mass of a yarn section. All members of the section must be positive.
[[nodiscard]] AbaqusSection abaqus_section(const yarn::Section& section);

/// The first axis (n1) of the section of an element along a direction: the z axis, normal to the fabric, unless the
/// element is within 45 degrees of it, then the coordinate axis that is nearest to a right angle to the element.
///
/// Abaqus uses n1 once, to lay the section's axes in the undeformed state; from then on they turn with the nodes, so it
/// is the undeformed direction that matters. @param direction [mm], any length but zero
/// @return 0 for x, 1 for y, 2 for z
[[nodiscard]] int first_axis(const Eigen::Vector3d& direction);

}  // namespace knitmech::exchange
