#pragma once

#include <string>

namespace knitmech::knit {

/// A number for a message, with four digits, rounded away from the side that would not do: the user can type what the
/// advice says and it works.
[[nodiscard]] std::string at_least(double value);
[[nodiscard]] std::string at_most(double value);

}  // namespace knitmech::knit
