#pragma once

#include "base/thread_team.h"

namespace knitmech::bench {

/// What the threads of a team can do at most, together.
struct Machine {
  double peak;    ///< [1/s], additions and multiplications of double precision
  double cache;   ///< [bytes/s], where all data of a thread fit its second-level cache
  double memory;  ///< [bytes/s], where they are far larger than all caches
};

/// Measures it, in a second or two. The peak is that of products and sums by separate instructions, as all of KnitMech
/// is compiled: with fused ones it would be larger. The bandwidths are those of a triad a = b + s c (J. D. McCalpin,
/// STREAM), with 32 bytes per entry: a is fetched before it is set. The shortest of several times counts.
[[nodiscard]] Machine measure_machine(const base::ThreadTeam& team);

}  // namespace knitmech::bench
