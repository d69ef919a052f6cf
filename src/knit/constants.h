#pragma once

namespace knitmech::knit {

/// Straight pieces per ERC [-] that stand for the true centreline when clearances are measured; 512 for every fabric.
/// An arc of radius R is cut short by at most h^2 / (8 R), h the piece: 4e-5 mm for a 9 mm ERC with R = 1 mm. More is
/// slower in proportion, fewer makes the measured gap of the curve less exact.
inline constexpr int kCurvePieces = 512;

/// Straight pieces per ERC [-] when the crossings of two courses in the plane of the fabric are counted.
/// More is slower with the square; fewer could miss a crossing that is passed twice within one piece.
inline constexpr int kCrossingPieces = 128;

/// Gap between neighbouring courses that out_of_plane = "auto" leaves, as a share of the yarn diameter [-]; usually
/// 0.05. Smaller brings the first contact of the test forward, larger gives a thicker fabric with a longer toe of the
/// curve.
inline constexpr double kAutomaticGap = 0.05;

/// Relative accuracy of an out-of-plane parameter found by bisection [-]. Tighter costs one evaluation per halving and
/// changes the gap by less than the sampling of the curve does.
inline constexpr double kOutOfPlaneAccuracy = 1e-6;

/// Largest depth of the loop p H^2 / 4, as a share of its height H [-], that the search for p tries. Beyond, the loop
/// is deeper than it is high, which no knitted fabric is; the search then reports that the courses cannot be separated.
inline constexpr double kLargestDepth = 1.0;

/// Two points of one yarn face each other only if the yarn between them is at least this many times as long as they are
/// apart, and as the yarn is thick [-]; pi / 2, as on a half circle. Smaller takes yarn that merely goes on for yarn
/// that comes back, larger overlooks tight loops.
inline constexpr double kSelfContactArc = 1.5707963267948966;

/// Overlap that still counts as touching, as a share of the yarn diameter [-]. Only rounding has to fit in, so that
/// loops exactly as wide as their stitch are accepted.
inline constexpr double kTouchingRounding = 1e-9;

/// Relative error of arc length at which the search for a point on the ERC ends [-]; a few units of rounding.
inline constexpr double kArcLengthAccuracy = 4e-16;

}  // namespace knitmech::knit
