#pragma once

#include <cstddef>

namespace knitmech::compare {

/// Intervals of the common strain grid [-]; usual 500. Twice as many change the differences of smooth curves by less
/// than a hundred thousandth.
inline constexpr std::size_t kGridIntervals = 500;

/// Least distance of a knot from both ends of the curve, as a share of its strains [-]; usual 0.05. Smaller lets a knot
/// follow the noise of the first or last few points.
inline constexpr double kKnotMargin = 0.05;

/// Growth of the slope at a knot, as a share of the slope after it, below which the curve does not lock there [-];
/// usual 0.05. Smaller calls the slightest bend of a line a locking.
inline constexpr double kLeastLocking = 0.05;

/// Share of the shorter curve that must remain in common with the other when an offset is sought [-]; usual 0.5.
/// Smaller finds larger offsets, and may lay the end of one curve on the begin of the other.
inline constexpr double kLeastOverlap = 0.5;

/// Offsets that are tried before the best is refined [-]; usual 400.
inline constexpr std::size_t kOffsetsTried = 400;

}  // namespace knitmech::compare
