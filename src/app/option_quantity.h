#pragma once

#include <optional>
#include <string>

#include "base/quantity.h"

namespace knitmech::app {

/// The quantity that an option gives as a text with a unit; empty if it is not given. Throws InputError that names the
/// option.
[[nodiscard]] std::optional<double> option_quantity(const char* option, const std::string& text,
                                                    base::Dimension dimension);

}  // namespace knitmech::app
