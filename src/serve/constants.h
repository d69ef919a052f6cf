#pragma once

#include <chrono>
#include <cstddef>

namespace knitmech::serve {

/// Least real time between two live views of a run [ms]; usual 100. Less shows smoother motion.
inline constexpr std::chrono::milliseconds kViewInterval{100};

/// Least real time between two live views, in times that it takes to make one [-]; usual 20. Less slows the run of a
/// large fabric down.
inline constexpr int kViewRest = 20;

/// Real time since someone asked for a live view during which further ones are made [s]; usual 5.
inline constexpr std::chrono::seconds kWatchedFor{5};

/// Least real time between two looks at runs under way for those who wait for changes [ms]; usual 100.
inline constexpr std::chrono::milliseconds kLookInterval{100};

/// Real time between two looks at the folder of runs for what other programs did there [s]; usual 2.
inline constexpr std::chrono::seconds kFolderInterval{2};

/// Runs whose files are kept in memory after they were read [-]; usual 2.
inline constexpr std::size_t kRunsInMemory = 2;

/// Longest name of a new run [bytes]; usual 80.
inline constexpr std::size_t kLongestName = 80;

/// Largest number of a frame that is asked for [-].
inline constexpr int kMostFrames = 1'000'000'000;

}  // namespace knitmech::serve
