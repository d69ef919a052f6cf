#pragma once

#include <string>

namespace knitmech::serve {

/// The table of parameters for the form of the page: `Parameters` of web/src/api/types.ts.
[[nodiscard]] std::string parameters_json();

}  // namespace knitmech::serve
