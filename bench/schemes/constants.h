#pragma once

/// Every number that tunes the comparison, with its unit, its usual value and what a change does.
namespace knitmech::bench {

/// As in a case that does not name them [-].
inline constexpr double kBulkViscosity = 0.06;
inline constexpr double kStepFactor = 0.9;

/// Intervals of strain in which explicit dynamics tells its force [-].
inline constexpr int kRows = 220;

/// Width of the windows of strain in which forces are compared, and where the first one begins [-].
inline constexpr double kWindow = 0.02;
inline constexpr double kFirstWindow = 0.08;

/// Most steps of dynamic relaxation for one increment of strain [-]; what is not at rest then is counted and left so.
inline constexpr long kMostRelaxationSteps = 20000;

/// Kinetic energy below which a peak is over, as a share of the largest since the last stop [-]. With 1, the vibrations
/// of single elements and contacts stop the fabric in every few steps, and slow motion never gets going.
inline constexpr double kFallenEnergy = 0.5;

/// Displacement [mm] and rotation [rad] of a difference quotient. Smaller: rounding; larger: contacts open and close.
inline constexpr double kDifference = 1e-7;

/// Most Newton iterations for one increment of strain [-], and as many after which the next one may be larger.
inline constexpr int kMostIterations = 40;
inline constexpr int kFewIterations = 8;

/// By how much an increment that fails is cut, and one that was easy grows [-].
inline constexpr double kCutBack = 0.5;
inline constexpr double kIncrementGrowth = 1.5;
/// Increment that is too small to go on, as a share of the largest [-].
inline constexpr double kLeastIncrement = 1.0 / 256;

/// Pseudo time of the first iteration, and the least and largest one, in stable steps of explicit dynamics [-]. With a
/// large one an iteration is one of Newton's method, with a small one a step of a heavily damped motion.
inline constexpr double kFirstPseudoTime = 1e3;
inline constexpr double kLeastPseudoTime = 0.3;
inline constexpr double kMostPseudoTime = 1e6;
/// By how much the pseudo time falls where an iteration fails, by how much it grows besides following the residual
/// where not, and by how much it grows at most [-]. Without the second it creeps: a hundred iterations in place of ten.
inline constexpr double kPseudoTimeCut = 0.25;
inline constexpr double kEasyGrowth = 3;
inline constexpr double kPseudoTimeGrowth = 10;
/// Growth of the residual that is no failure [-]: a contact that closes, closes with a force.
inline constexpr double kResidualGrowth = 1.5;
/// Largest motion of a node in one iteration [yarn radii].
inline constexpr double kLargestIteration = 0.5;

}  // namespace knitmech::bench
