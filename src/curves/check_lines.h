#pragma once

#include <cstddef>
#include <string>

#include "curves/yarn_lines.h"

namespace knitmech::curves {

/// Throws InputError unless every yarn has the points that its kind of line needs, and all numbers are finite and not
/// absurdly large. There must be a yarn, and not more than kMostYarns.
void check_lines(const YarnLines& lines);

/// Where a yarn ends exactly where it begins, it is closed, and the point that it has twice goes.
void close_where_ends_meet(YarnLine& yarn);

/// "yarn 3", counted from 1, for messages.
[[nodiscard]] std::string yarn_text(std::size_t index);

}  // namespace knitmech::curves
