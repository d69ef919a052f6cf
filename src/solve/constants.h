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

/// Finest length d of selective mass as a share of the half stitch [-]: the axial frequency of the yarns is that of
/// elements of this length. Measured on examples/02-wale-tension against lumped masses: with 0.3, 0.4 and 0.6 the steps
/// are 2.2, 2.5 and 2.8 times fewer, and the force differs by at most 0.1, 0.3 and 0.4 %, to 22 % strain. Waves as long
/// as a stitch have the inertia of (pi d / 2 l)^2 times their own besides, 0.89 with 0.6; with 0.9, two times their
/// own, single parts of the curve beyond 26 % strain differ by 2 %. See docs/theory.md, section 10.
inline constexpr double kSelectiveShare = 0.6;

/// Least of the numbers by which the frequency of contact on selective masses is bounded, as a share of the largest
/// [-]. Smaller: closer where few nodes touch, and too high where a contact has just begun.
inline constexpr double kLeastTrial = 0.02;

/// Speed of the grip times the square root of the mass scaling, in units of the speed at which a bent half stitch can
/// follow (see automatic_mass_scaling()) [-]. Measured on examples/02-wale-tension: after the toe, the kinetic energy
/// is at most 2.2 % of the internal one; with 0.03 it is 9.9 %, and the work at 22 % strain 1.1 % larger. The number of
/// steps falls in proportion.
inline constexpr double kQuasiStaticSpeed = 0.018;

/// Steps between two looks of the pace at the energies of the fabric [-]. Fewer: it feels a snap sooner, and looks cost
/// more.
inline constexpr long kPaceInterval = 100;

/// Pace, as a multiple of the speed that kQuasiStaticSpeed stands for, while the fabric gives nearly without force and
/// where it snaps [-]. Measured on the fabric of the main example on chords: with 1, 2 and 4 the force between 14 and
/// 20 % strain is 0.5, 2 and 9 % larger than in a test with an eighth of the mass. The steps of that part fall in
/// proportion.
inline constexpr double kCalmPace = 2;
/// The slowest pace [-], where kinetic energy has to fall.
inline constexpr double kSlowestPace = 0.6;

/// Final strain below which the pace falls in proportion to it, so that a short test takes as long as one to this
/// strain [-]. A bent loop swings about once while the grip goes on by a hundredth at kCalmPace. Smaller: in short
/// tests the loops lag behind the grip. Measured on one stitch to 0.4 %: the kinetic energy is 0.03 % of the internal
/// one, and 19 % of it without this.
inline constexpr double kShortTest = 0.1;

/// Strain energy, as a share of EI / l of every half stitch, from which on the grip may move faster than at kCalmPace
/// [-]. It is reached where the loops have closed and the fabric draws in: of all places the one where inertia across
/// the pull shows most in the force. Smaller: faster, and less exact there.
inline constexpr double kTautEnergy = 0.03;

/// Kinetic energy of the motion relative to an even stretch over strain energy that the pace tends to [-]. Larger:
/// faster, and the fabric comes to rest less between two snaps. Measured on the fabric of the main example to 42 %,
/// when kSelectiveShare was 0.3: with 0.007, 0.01 and 0.02 it took 248 000, 217 000 and 177 000 steps, and the work was
/// 1.6 and 2.8 % larger than with the first.
inline constexpr double kStrayGoal = 0.01;

/// Kinetic over strain energy that the pace tends to where results are judged [-]; the limit there is 0.05 (see
/// results/constants.h), of which a snap needs its part. Smaller: slower just behind the toe.
inline constexpr double kKineticGoal = 0.03;
/// Share of the final strain up to which a test is surely in its toe, which is not judged, and from which on
/// kKineticGoal holds in full [-]. Toes of jersey end at 0.6 to 0.7 of the final strain.
inline constexpr double kUnjudgedShare = 0.5;
inline constexpr double kJudgedShare = 0.6;

/// Strains over which the pace averages energies [-]: to speed up and to slow down ...
inline constexpr double kPaceMemory = 2e-3;
/// ... and to notice a snap.
inline constexpr double kPaceShortMemory = 5e-4;

/// Strains in which the grip may gain or lose as much speed as it has [-]. Smaller: the pace follows the fabric more
/// closely, and disturbs it more.
inline constexpr double kSpeedingUpStrain = 0.02;
inline constexpr double kBrakingStrain = 2e-3;
/// Inertia of the fabric under the acceleration of the grip, as a share of the force that it bears [-]. The even
/// stretch takes most of it (see EvenStretch).
inline constexpr double kSpeedingUpForce = 0.04;
inline constexpr double kBrakingForce = 0.1;
/// However small the force is, the grip may change its speed by kCalmPace within this strain [-]; at the start, where
/// nothing bears yet, within the second.
inline constexpr double kGentleStrain = 0.02;
inline constexpr double kStartStrain = 2e-3;

/// Least number of elements for a thread [-], about 5 microseconds of work for beams and integration in every step.
/// Measured by bench/step_bench.cpp: a second thread takes them to 1.5 times the speed in a fabric of 700 elements,
/// to 1.7 times at 1300 and to 1.9 times at 2700. Fewer: threads that wait for each other more than they work.
inline constexpr int kElementsPerThread = 500;

/// Steps between two questions to the caller whether to go on [-].
inline constexpr long kAskInterval = 50;

}  // namespace knitmech::solve
