#pragma once

#include <cstddef>

namespace knitmech::results {

/// Limits below which a tensile test counts as quasi-static. A smaller value makes the verdict stricter and changes no
/// result.

/// Largest kinetic energy over internal energy after the toe region, both averaged over a window [-]; usual 0.05.
inline constexpr double kKineticRatioLimit = 0.05;

/// Largest energy that is missing from or added to the balance, over the external work [-]; usual 0.01.
inline constexpr double kEnergyBalanceLimit = 0.01;

/// Largest difference of the two grip forces over their mean, averaged over a window [-]; usual 0.05.
inline constexpr double kGripDifferenceLimit = 0.05;

/// Strain range over which grip forces and kinetic energy are averaged before they are judged [-]; usual 0.01. A wider
/// window forgives longer waves running through the fabric. A loop that snaps at the free side moves fast however
/// slowly the grip goes; the average asks whether that motion dies away.
inline constexpr double kWindow = 0.01;

/// Share of the largest external work at which the toe region ends [-]; usual 0.1. A larger value leaves more of the
/// start of the test unjudged.
inline constexpr double kToeWorkShare = 0.1;

/// Strain energy at which the toe of the curve ends, as a share of model::bending_measure() [-]; usual 0.005: that of
/// half stitches which are each bent evenly by a tenth of a radian. The loops have closed, and the curve of the main
/// example leaves its flat start. As the energy climbs steeply there, twice the share moves the limit by less than a
/// tenth of itself.
inline constexpr double kToeEnergy = 0.005;

/// Turn over an element below which it is straight in plan [rad]; usual 1e-6, far above rounding and far below any arc.
/// It tells the leg of a loop from its arcs.
inline constexpr double kStraightLeg = 1e-6;

/// Real time between two rewrites of history.csv [s]; usual 1. A killed run loses at most the rows of this time.
inline constexpr double kHistoryRewriteInterval = 1.0;

/// Frames that are written beside the run at most, the one that is being written included [-]; usual 2. More bridge a
/// longer pause of the disk, at the memory of a frame each, about 200 bytes a node.
inline constexpr std::size_t kMostPendingWrites = 2;

}  // namespace knitmech::results
