#pragma once

#include "yarn/section.h"

namespace knitmech::yarn {

/// Section of a monofilament with a circular section:
///   A = pi D^2 / 4,  I = pi D^4 / 64,  J = 2 I,  G = E / (2 (1 + nu)),  k = 6 (1 + nu) / (7 + 6 nu).
///
/// D = 0.12 mm, E = 1700 MPa, nu = 0.39 give EA = 19.2265 N, EI = 0.0173039 N mm^2, GJ = 0.0124488 N mm^2.
/// A measured G takes the place of E / (2 (1 + nu)); the nu in k is then the one that E and G imply, moved into 0 to
/// 0.5 where they imply one outside (k lies between 0.857 and 0.9 in any case). Throws InputError unless D, E, rho and
/// a given G are positive and, without G, -1 < nu <= 0.5. Source of k: G. R. Cowper, The shear coefficient in
/// Timoshenko's beam theory, J. Appl. Mech. 33 (1966), doi:10.1115/1.3625046.
[[nodiscard]] Section section_of(const Monofilament& monofilament);

/// A yarn whose stiffness is given outright, as from bending and torsion tests.
struct MeasuredYarn {
  double diameter = 0;             ///< D [mm], seen by the contact
  double density = 0;              ///< rho [t/mm^3], of a full circle of diameter D
  double axial_stiffness = 0;      ///< EA [N]
  double bending_stiffness = 0;    ///< EI [N mm^2]
  double torsional_stiffness = 0;  ///< GJ [N mm^2]
};

/// Section of a yarn whose EA, EI and GJ are given outright; its mass is that of a circle of diameter D.
///
/// Nobody measures the shear stiffness of a yarn, and a slender one hardly feels it. It is taken from EA as for a solid
/// circle, k EA / (2 (1 + nu)), with the nu that EI and GJ imply in a solid circle, EI / GJ = 1 + nu, moved into 0 to
/// 0.5 where they imply one outside. So a monofilament and the same yarn given by its EA, EI and GJ are one section.
/// Throws InputError unless all five numbers are positive.
[[nodiscard]] Section section_of(const MeasuredYarn& yarn);

/// Shear factor of a solid circle, k = 6 (1 + nu) / (7 + 6 nu) [-] (Cowper 1966).
[[nodiscard]] double circle_shear_factor(double poissons_ratio);

}  // namespace knitmech::yarn
