#pragma once

#include "run/load_case.h"

namespace knitmech::run {

/// What a run will take, roughly.
struct RunEstimate {
  double steps = 0;
  double seconds = 0;  ///< [s], of real time, with the threads that the program chooses
};

/// Guesses the length of a run from its case: the steps within some 40 %, the time within a factor of about three, as
/// computers differ.
///
/// The stable step is set by the contacts of half stitches of the scaled mass s rho A l, l their length, on the contact
/// stiffness k; with the speed that automatic_mass_scaling() allows, the grip moves by kQuasiStaticSpeed
/// sqrt(EI / (k l)) in each, so that the steps go with gauge length, strain and sqrt(k l / EI), whatever the mesh.
/// Where the case gives the mass itself, the step is that or the one of an element, and the speed the one that is
/// given. The time goes with elements and stitches and, once the loops are closed, with the stitches in contact. The
/// constants are fitted to examples/02-wale-tension, to 8, 22, 32 and 42 % strain, with 10 and 20 elements per ERC, and
/// with 4 x 6 and 20 x 20 stitches.
[[nodiscard]] RunEstimate estimate_run(const LoadedCase& loaded);

}  // namespace knitmech::run
