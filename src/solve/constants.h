#pragma once

/// Every number that tunes the time stepping, with its unit, its usual value and what a change does.
namespace knitmech::solve {

/// Steps between two looks at the stable step and at the state of the nodes [-]. Fewer: safer and a little slower.
inline constexpr long kWatchInterval = 10;

/// Contacts on one node that the first time step has room for [-], at small penetration. Fewer: a larger first step,
/// which then has to shrink more often.
inline constexpr double kExpectedContacts = 2;

/// Share of the allowed step that a shrinking step is set to [-], so that it need not shrink again soon.
inline constexpr double kStepReserve = 0.95;

/// Growth of a step that has been held down, at a time [-], and looks at the model between two growths [-].
inline constexpr double kStepGrowth = 1.05;
inline constexpr int kCalmLooks = 100;

/// Share of the yarn radius that a node may move in one step [-]. With it, no yarn can jump over another between two
/// looks of the contact.
inline constexpr double kLargestMove = 0.1;

/// Share of the distance between two tied points that is taken back in one step [-]. Larger: they stay closer together,
/// and the ties do more work.
inline constexpr double kTieRecovery = 0.1;

/// How often the forces of all ties are found in turns in one step [-]; the forces of the step before are the start.
/// More: ties that share nodes agree better.
inline constexpr int kTieTurns = 3;

/// A step this many times smaller than the first one means that the simulation has run away [-].
inline constexpr double kStepCollapse = 1e-4;

/// The run stops when stored and lost energy exceed the external work by this factor [-]: a fabric cannot give back
/// more than was put in ...
inline constexpr double kEnergyBlowUp = 1.5;
/// ... provided that they exceed this share of EI / D [-], the bending energy of a yarn wound around itself by about
/// one diameter of its length. Below it, a fabric that hardly carries anything yet would trip over rounding.
inline constexpr double kEnergyNoise = 1e-3;

/// Speed of the grip times the square root of the mass scaling, in units of the speed at which a bent half stitch can
/// follow (see automatic_mass_scaling()) [-]. Measured on examples/02-wale-tension: after the toe, the kinetic energy
/// is at most 2.2 % of the internal one; with 0.03 it is 9.9 %, and the work at 22 % strain 1.1 % larger. The number of
/// steps falls in proportion.
inline constexpr double kQuasiStaticSpeed = 0.018;

/// Steps between two questions to the caller whether to go on [-].
inline constexpr long kAskInterval = 50;

}  // namespace knitmech::solve
