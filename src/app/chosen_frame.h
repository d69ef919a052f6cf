#pragma once

#include <iosfwd>
#include <optional>

#include "results/read_run.h"

namespace knitmech::app {

/// The number of the stored frame that the command line asks for: the one given, the one nearest to a strain [-], or
/// else the last. Says on `messages` which one it took for a strain.
[[nodiscard]] int chosen_frame(const results::StoredRun& run, std::optional<int> number, std::optional<double> strain,
                               std::ostream& messages);

/// @throws InputError for a strain that is no number
void check_strain(std::optional<double> strain);

}  // namespace knitmech::app
