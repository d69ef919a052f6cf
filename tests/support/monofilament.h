#pragma once

#include <cmath>

#include "beam_case.h"

namespace knitmech::test {

/// The monofilament of the examples: D = 0.12 mm, E = 1700 MPa, nu = 0.39, 1140 kg/m^3.
inline constexpr double kAxial = 19.2265;              ///< EA [N]
inline constexpr double kShear = 6.17;                 ///< k G A [N]
inline constexpr double kBending = 0.0173039;          ///< EI [N mm^2]
inline constexpr double kTorsion = 0.0124488;          ///< GJ [N mm^2]
inline constexpr double kMassPerLength = 1.29e-11;     ///< [t/mm]
inline constexpr double kMonofilamentDiameter = 0.12;  ///< [mm]

inline yarn::Section monofilament(double torsion = kTorsion) {
  return section(kAxial, kShear, kBending, torsion, kMassPerLength);
}

/// Lowest angular frequency of a cantilever, 3.516 sqrt(EI / (rho A L^4)) [1/s].
inline double slowest_frequency(double bending, double mass_per_length, double length) {
  return 3.516 * std::sqrt(bending / mass_per_length) / (length * length);
}

}  // namespace knitmech::test
