#pragma once

#include <cstddef>

namespace knitmech::curves {

/// Largest file of yarns that is read [bytes]; some ten million points. More would not fit a simulation.
inline constexpr std::size_t kLargestFile = 200'000'000;

/// Most yarns of a file [-]. What has more is hair, or damaged.
inline constexpr std::size_t kMostYarns = 1'000'000;

/// Largest coordinate and radius of a file [length of the file]. What is beyond has slipped, or is damaged.
inline constexpr double kLargestCoordinate = 1e9;

/// Pieces of equal parameter [-] into which the length of a cubic arc is cut to be measured and inverted; usually 16.
/// More is slower in proportion; the error of the length goes with the sixth power of a piece.
inline constexpr int kPiecesPerArc = 16;

/// Speed along an arc, as a share of the length of its corners, below which its direction is taken from the points
/// beside it [-]. Only points that coincide come near.
inline constexpr double kStandstill = 1e-9;

/// Two points of one yarn face each other only if the yarn between them is at least this many times as long as they are
/// apart, and as the yarn is thick [-]; pi / 2, as on a half circle. Smaller takes yarn that merely goes on for yarn
/// that comes back, larger overlooks tight loops.
inline constexpr double kComesBack = 1.5707963267948966;

}  // namespace knitmech::curves
