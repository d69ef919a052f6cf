#pragma once

#include <string>
#include <vector>

#include "schemes/scheme.h"

namespace knitmech::bench {

/// The line of a scheme beside the reference, the names of whose columns are in table_head(): evaluations of the
/// forces, processor time, work at the end, mean force in the last window of strain, how far both are from the
/// reference, and the largest such difference of the mean force in any window from kFirstWindow on.
[[nodiscard]] std::string table_row(const SchemeResult& result, const SchemeResult& reference);
[[nodiscard]] std::string table_head();

}  // namespace knitmech::bench
