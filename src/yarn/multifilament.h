#pragma once

#include "yarn/section.h"

namespace knitmech::yarn {

/// What one filament adds to its yarn when it winds around the yarn's axis as a helix.
struct HelicalFilament {
  double axial_stiffness = 0;      ///< [N]
  double shear_stiffness = 0;      ///< [N]
  double bending_stiffness = 0;    ///< B1 [N mm^2]
  double torsional_stiffness = 0;  ///< K1 [N mm^2]
  double mass_per_length = 0;      ///< [t/mm], per length of the yarn
};

/// A filament at the helix angle Q to the yarn's axis. Per length of yarn it is 1 / cos Q long.
///
/// Bending and torsion follow from its strain energy. A moment M, the same all along the filament, has the part M.t
/// along its tangent t = (-sin Q sin p, sin Q cos p, cos Q), which twists it, and the rest, which bends it, so that per
/// length of yarn  M^2 / (2 B1) = mean over the turn of ((M.t)^2 / (2 GJ) + (M^2 - (M.t)^2) / (2 EI)) / cos Q.
///   M across the axis, mean (M.t)^2 = M^2 sin^2 Q / 2:  1/B1 = (sin^2 Q / (2 GJ) + (1 - sin^2 Q / 2) / EI) / cos Q
///   M along the axis,       (M.t)^2 = M^2 cos^2 Q:      1/K1 = (cos^2 Q / GJ + sin^2 Q / EI) / cos Q
/// These are the stiffnesses of a helical spring (A. M. Wahl, Mechanical Springs, 1944, on bending and torsion of
/// springs). A shear force across the axis does to the filament what the bending moment does, with EA in place of GJ
/// and k G A in place of EI.
///
/// Axial: the filament is held at its radius by its neighbours. A yarn strain e stretches it by e cos^2 Q, and the part
/// cos Q of its force acts along the yarn: EA cos^3 Q. (Without neighbours it would unwind like a spring.)
///
/// @param filament section of the filament by itself
/// @param helix_angle Q [rad], at least 0 and below pi/2
[[nodiscard]] HelicalFilament helical_filament(const Section& filament, double helix_angle);

/// Section of a yarn of n filaments that lie evenly spread over the cross-section, twisted together and free to slide.
///
/// A filament whose axis is at the radius r lies at the helix angle Q, tan Q = 2 pi r t. Axes reach out to
/// R = (D - d_f) / 2, where the filament touches the yarn's surface, and there are as many in every equal area. All
/// follow the yarn's curvature, twist and strain, so their stiffnesses add: n times the mean of helical_filament().
/// With v = 1 / cos Q an area is proportional to the change of v^2, and with V = v at R every mean is closed:
///   mean f    = 2 / (V + 1) * (mean over v from 1 to V of f v)
///   axial     EA_f 2 / (V (V + 1))
///   mass      rho A_f 2 (V^2 + V + 1) / (3 (V + 1))
///   bending   2 / (V + 1) * 2 EI GJ / (EI + GJ) * m((EI - GJ) / (EI + GJ));   shear likewise
///   torsion   2 / (V + 1) * EI * m(1 - EI / GJ)
/// where m(q) = mean over v of v^2 / (v^2 - q). Without twist V = 1, and all are those of n straight filaments. One
/// filament of the yarn's own diameter lies on the axis. Crimp, friction between filaments and the thinning of the yarn
/// under load are left out.
///
/// Throws InputError for wrong values of the filament, fewer than one filament, a diameter that is not positive, a
/// twist that is negative or not finite, and filaments that do not fit into the yarn: n d_f^2 > D^2.
[[nodiscard]] Section section_of(const Multifilament& yarn);

}  // namespace knitmech::yarn
